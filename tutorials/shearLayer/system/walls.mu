// Couple traction on the walls given

"(top|bottom)"
{
    type            coupleTraction;
    coupleTraction  uniform $mu;
    value           uniform 0;
}
