// The gap between two cylinders, one cell deep. To make the mesh:
//     gmsh -3 -format msh22 cylinders.geo

inner = 1;          // radii
outer = 2;
e = 0.5;            // distance of the axes
depth = 0.1;
size = 0.13;        // of the cells, at the outer cylinder

Point(1) = {0, 0, 0};
Point(2) = {outer, 0, 0, size};
Point(3) = {0, outer, 0, size};
Point(4) = {-outer, 0, 0, size};
Point(5) = {0, -outer, 0, size};

Point(11) = {e, 0, 0};
Point(12) = {e + inner, 0, 0, size/2};
Point(13) = {e, inner, 0, 3*size/4};
Point(14) = {e - inner, 0, 0, 3*size/4};
Point(15) = {e, -inner, 0, 3*size/4};

Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 2};
Circle(11) = {12, 11, 13};
Circle(12) = {13, 11, 14};
Circle(13) = {14, 11, 15};
Circle(14) = {15, 11, 12};

Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(1) = {1, 2};

gap[] = Extrude {0, 0, depth} { Surface{1}; Layers{1}; Recombine; };

Physical Surface("frontAndBack") = {1, gap[0]};
Physical Surface("outer") = {gap[2], gap[3], gap[4], gap[5]};
Physical Surface("inner") = {gap[6], gap[7], gap[8], gap[9]};
Physical Volume("gap") = {gap[1]};
