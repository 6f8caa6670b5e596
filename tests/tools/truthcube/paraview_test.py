"""Opens what truthcube and softbody write in ParaView: paraview_test.py FILE.xdmf... [--picture PICTURE.png], by pvpython.

Every step must be there, at its time, and every field must have the numbers of the VTKHDF file beside it, to the last bit, which h5py
reads. --picture draws the last step of the last file, warped and coloured by how far it moved; that needs a display (xvfb-run)."""
import sys

import h5py
import numpy as np
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy


def check(name):
    reader = simple.OpenDataFile(name)
    with h5py.File(name.removesuffix(".xdmf") + ".vtkhdf", "r") as file:
        data = file["VTKHDF"]
        times = list(data["Steps/Values"])
        assert list(np.atleast_1d(reader.TimestepValues)) == times, (name, reader.TimestepValues, times)
        for step, time in enumerate(times):
            reader.UpdatePipeline(time)
            grid = servermanager.Fetch(reader)
            assert grid.IsA("vtkUnstructuredGrid"), grid.GetClassName()
            assert np.array_equal(vtk_to_numpy(grid.GetPoints().GetData()), data["Points"]), "points"
            corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
            assert np.array_equal(corners, data["Connectivity"]), "tets"
            for kind, found in (("PointData", grid.GetPointData()), ("CellData", grid.GetCellData())):
                for field, stored in data[kind].items():
                    rows = found.GetNumberOfTuples()
                    first = step * rows if len(stored) == rows * len(times) else 0  # groups are stored once for all steps
                    array = found.GetArray(field)
                    assert array is not None, f"{name}: ParaView has no {field}"
                    assert np.array_equal(vtk_to_numpy(array), stored[first : first + rows]), f"{name}: {field} of step {step}"
                assert found.GetNumberOfArrays() == len(data[kind]), name
            print(f"{name}: time {time:g}: {grid.GetNumberOfPoints()} points, {grid.GetNumberOfCells()} cells,", *data["PointData"], *data["CellData"])
    return reader


def draw(reader, picture):
    warped = simple.WarpByVector(reader, Vectors=["POINTS", "displacement"], ScaleFactor=1)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewTime = np.atleast_1d(reader.TimestepValues)[-1]
    shown = simple.Show(warped, view)
    simple.ColorBy(shown, ("POINTS", "displacement", "Magnitude"))
    shown.RescaleTransferFunctionToDataRange()
    shown.SetScalarBarVisibility(view, True)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (0.1, -1, 0.3), (0, 0, 0), (0, 0, 1)
    view.ResetCamera()
    simple.SaveScreenshot(picture, view, ImageResolution=(600, 450))


names = sys.argv[1:]
picture = names.pop(names.index("--picture") + 1) if "--picture" in names else None
readers = [check(name) for name in names if name != "--picture"]
if picture:
    draw(readers[-1], picture)
