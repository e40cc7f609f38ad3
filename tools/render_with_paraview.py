"""pvbatch tools/render_with_paraview.py RUN_FOLDER IMAGE.png [FIELD]

Opens a run's particles.pvd and walls.vtp in ParaView, colours the last frame by FIELD (default
pressure) and saves a picture. Fails when the frames lack a time, points or the field, or when the
picture shows nothing but background. Headless: xvfb-run -a pvbatch ...
"""

import pathlib
import sys

import vtk
from paraview import simple

folder, image = pathlib.Path(sys.argv[1]), sys.argv[2]
field = sys.argv[3] if len(sys.argv) > 3 else "pressure"


def shown(source, view):
    display = simple.Show(source, view)
    display.SetRepresentationType("Points")
    display.PointSize = 5
    return display


def colours_of(picture):
    """Number of different colours in a PNG file."""
    reader = vtk.vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    pixels = reader.GetOutput().GetPointData().GetScalars()
    return len({pixels.GetTuple(k) for k in range(pixels.GetNumberOfTuples())})


frames = simple.PVDReader(FileName=str(folder / "particles.pvd"))
times = list(frames.TimestepValues)
assert len(times) > 1 and times == sorted(set(times)), f"times of the frames: {times}"
frames.UpdatePipeline(times[-1])
points = frames.GetDataInformation().GetNumberOfPoints()
assert points > 0, "the last frame is empty"
fields = frames.PointData.keys()
assert field in fields, f"no field {field} among {fields}"

view = simple.CreateView("RenderView")
view.ViewSize = [800, 700]
view.ViewTime = times[-1]
display = shown(frames, view)
simple.ColorBy(display, ("POINTS", field))
display.RescaleTransferFunctionToDataRange(False, True)
display.SetScalarBarVisibility(view, True)
if (folder / "walls.vtp").exists():
    walls = simple.XMLPolyDataReader(FileName=[str(folder / "walls.vtp")])
    simple.ColorBy(shown(walls, view), None)
simple.ResetCamera(view)
simple.SaveScreenshot(image, view)
colours = colours_of(image)
assert colours > 50, f"only {colours} colours in the picture"
print(f"{image}: {points} particles at {times[-1]:g} s, {len(times)} frames, {colours} colours")
