#include "fvCFD.H"
#include "creepingFlow.H"

int main(int argc, char *argv[])
{
    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"
    #include "createTime.H"
    #include "createMesh.H"

    autoPtr<uniformDimensionedVectorField> g(new uniformDimensionedVectorField(IOobject("g", runTime.constant(), runTime, IOobject::READ_IF_PRESENT), dimensionedVector(dimAcceleration, Zero)));
    materialFields materials(mesh);
    creepingFlow flow(materials);
    materials.correct();
    while (runTime.loop())
    {
        Info<< "Time = " << runTime.timeName() << nl << endl;
        flow.solve();
        auto P = flow.power();
        Info << "power " << P.gravity << " " << P.walls << " " << P.viscous << " " << P.bending << " " << P.pressure << endl;
        runTime.write();
        Info<< "ExecutionTime = " << runTime.elapsedCpuTime() << endl;
    }
    return 0;
}
