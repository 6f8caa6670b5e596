// Two boxes that share a face, with groups of both, of that face, of an edge, and of a point apart. The files of this
// folder are from Gmsh 4.8.4: gmsh two_boxes.geo -3 -save_parametric -format msh22 (or msh41) [-bin] -o FILE
h = 1;
Point(1) = {0, 0, 0, h}; Point(2) = {1, 0, 0, h}; Point(3) = {1, 1, 0, h}; Point(4) = {0, 1, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
lower[] = Extrude {0, 0, 1} { Surface{1}; };
upper[] = Extrude {0, 0, 1} { Surface{lower[0]}; };
Point(100) = {5, 5, 5, h};
Physical Volume("lower", 1) = {lower[1]};
Physical Volume("upper", 2) = {upper[1]};
Physical Surface("between", 3) = {lower[0]};
Physical Curve("edge", 4) = {1};
Physical Point("apart", 5) = {100};
