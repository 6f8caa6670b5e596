// The Python module everything of the object types in everything.h. Written by physgen: change the schema, not this
// file.
#include <physgen/python/module.h>

#include "everything.physgen.h"

PYBIND11_MODULE(everything, module) {
  physgen::python::add_class<tissue::StampObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(
      module, "Stamp",
      "A moment, of a namespace around those of the others.\n"
      "\n"
      "time : Scalar [s]\n"
      "step : Scalar\n");
  physgen::python::add_class<tissue::model::ShapesObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(
      module, "Shapes",
      "Every structure, with elements of every type.\n"
      "\n"
      "a : Scalar\n"
      "    Scalar.\n"
      "v : Vector<3>\n"
      "nodes : Vector<4>\n"
      "    corners i, j, k, l\n"
      "F : Matrix<3, 3> [1]\n"
      "    deformation gradient\n"
      "B : Matrix<2, 3>\n"
      "row : Matrix<1, 4>\n"
      "K : Symmetric<3> [N/m]\n"
      "C2 : Symmetric<2>\n"
      "s : Diagonal<3>\n"
      "W : Skew<3> [1/s]\n"
      "U : Rotation\n"
      "    principal directions\n"
      "V : Rotation\n"
      "count : Vector<2>\n"
      "M : Matrix<2, 2>\n");
  physgen::python::add_class<tissue::model::NamesObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(
      module, "Names",
      "Names that generated code uses elsewhere.\n"
      "\n"
      "value : Scalar\n"
      "entry : Scalar\n"
      "S : Scalar\n"
      "R : Scalar\n"
      "at : Scalar\n"
      "cursor : Scalar\n"
      "name : Scalar\n"
      "fields : Scalar\n"
      "Layout : Scalar\n"
      "host : Scalar\n"
      "plan : Scalar\n"
      "slot : Scalar\n"
      "stride : Scalar\n"
      "offset : Scalar\n"
      "format : Scalar\n"
      "Native : Scalar\n"
      "PerSpace : Scalar\n"
      "field : Scalar\n"
      "element : Scalar\n"
      "nested : Scalar\n"
      "self : Scalar[2]\n"
      "assign : Scalar\n"
      "texts : Scalar\n"
      "Inner : Scalar\n"
      "tissue : Vector<2>\n");
  physgen::python::add_class<tissue::model::EntriesObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(
      module, "Entries",
      "Fixed arrays.\n"
      "\n"
      "weights : Scalar[5] [1]\n"
      "    Weights of the five points.\n"
      "    They sum to one.\n"
      "k : Symmetric<3>[4] [N/m]\n"
      "flags : Scalar[3]\n"
      "history : Scalar[40]\n"
      "    More entries than are worth unrolling\n"
      "edges : Vector<2>[6]\n"
      "entry : Scalar[2]\n");
  physgen::python::add_class<tissue::model::OptionsObject, physgen::Soa, physgen::AosPadded>(
      module, "Options",
      "Units, ranges and initial values. The text of this comment is long enough to need a second line, because it goes on\n"
      "and on without saying anything else.\n"
      "\n"
      "  An indented line.\n"
      "The last line.\n"
      "\n"
      "density : Scalar [kg/m^3]\n"
      "    Mass per volume of the rest shape.\n"
      "nu : Scalar\n"
      "direction : Vector<3> [1]\n"
      "metric : Symmetric<3>\n"
      "label : Scalar\n"
      "group : Vector<2>\n"
      "spin : Skew<3>\n"
      "fixed : Scalar\n");
  physgen::python::add_class<tissue::model::ElementObject, physgen::Aos, physgen::Aosoa<64>>(
      module, "Element",
      "Nested objects of every alignment.\n"
      "\n"
      "flag : Scalar\n"
      "    Before the nested objects by name, behind them in the record.\n"
      "lame : material::Lame\n"
      "    Constants of the tissue.\n"
      "fibres : material::Fibre[2]\n"
      "stamp : tissue::Stamp\n"
      "shapes : tissue::model::Shapes\n"
      "volume : Scalar [m^3]\n");
  physgen::python::add_class<tissue::other::PatchObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(
      module, "Patch",
      "elements : tissue::model::Element[2]\n"
      "weight : Scalar\n"
      "options : tissue::model::Options\n");
  physgen::python::add_class<tissue::model::FrameObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(
      module, "Frame",
      "A place and a direction, compact on CUDA.\n"
      "\n"
      "turn : Rotation\n"
      "origin : Vector<3> [m]\n"
      "weight : Scalar\n");
  physgen::python::add_class<tissue::model::StoredObject, physgen::Aosoa<8>, physgen::Aosoa<32>>(
      module, "Stored",
      "Every storage format.\n"
      "\n"
      "single : Scalar\n"
      "twice : Scalar\n"
      "narrowed : Scalar\n"
      "plain_half : Scalar\n"
      "load : Scalar [N]\n"
      "    External force.\n"
      "wide : Scalar\n"
      "angle : Scalar [rad]\n"
      "temperature : Scalar [K]\n"
      "stress : Symmetric<3> [Pa]\n"
      "F : Matrix<3, 3>\n"
      "stretch : Diagonal<3>\n"
      "spin : Skew<3>\n"
      "R : Rotation\n"
      "R32 : Rotation\n"
      "R64 : Rotation\n"
      "Rhalf : Rotation\n"
      "Rbfloat : Rotation\n"
      "R16 : Rotation\n"
      "entries : Rotation\n"
      "halves : Scalar[5]\n"
      "turns : Rotation[3]\n"
      "many : Rotation[33]\n"
      "count : Scalar\n"
      "frame : tissue::model::Frame\n"
      "frames : tissue::model::Frame[2]\n");
  physgen::python::add_class<tissue::model::MarksObject, physgen::Aosoa<16>, physgen::Aosoa<32>>(
      module, "Marks",
      "Integers of 64 bits and bools, in every shape that has them.\n"
      "\n"
      "lowest : Scalar\n"
      "key : Scalar\n"
      "alive : Scalar\n"
      "    whether it takes part\n"
      "fixed : Vector<3>\n"
      "counts : Matrix<2, 2>\n"
      "touches : Symmetric<3>\n"
      "hashes : Diagonal<2>\n"
      "turns : Skew<3>\n"
      "flags : Scalar[5]\n"
      "history : Scalar[2]\n"
      "weight : Scalar [kg]\n");
#ifdef PHYSGEN_PYTHON_SOURCES
  physgen::python::add_functions(module);
#endif
}
