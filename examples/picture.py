"""Draws the pictures of the examples from the VTU files of a run.

    python examples/picture.py arch results/arch examples/arch/arch.png
    python examples/picture.py wall results/wall examples/wall/wall.png

Needs vtk, numpy and matplotlib. It also shows how to read the files in Python.
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# steps shown, height of the picture, magnification of the displacements, cell array,
# its factor, limits and label
PICTURES = {
    "arch": ([3000, 10000], 3.3, 1, "von Mises stress", 1e-6, (0, 4), "von Mises stress (MPa)"),
    "wall": ([1800, 12000], 4.2, 20, "Cauchy stress", 1e-6, (-6, 0), "σyy (MPa)"),
}
COLOURS = {1: "#e08214", 2: "#d7191c"}


def read(path):
    """Points, connectivity, point arrays, cell arrays and time of a VTU file."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()

    def arrays(data):
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        return {name: vtk_to_numpy(data.GetArray(name)) for name in names}

    points = vtk_to_numpy(grid.GetPoints().GetData())[:, :2]
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    time = arrays(grid.GetFieldData())["TimeValue"][0]
    return points, cells, arrays(grid.GetPointData()), arrays(grid.GetCellData()), time


def draw(axes, name, folder, step, magnification, array, factor, limits):
    points, cells, of_points, of_cells, time = read(folder / f"{name}_{step:07}.vtu")
    points = points + (magnification - 1) * of_points["displacement"][:, :2]
    values = of_cells[array] * factor
    values = values[:, 1] if values.ndim > 1 else values
    triangles = cells.reshape(-1, 3)
    colours = "viridis" if limits[0] >= 0 else "viridis_r"
    drawn = axes.tripcolor(*points.T, triangles, facecolors=values, cmap=colours,
                           vmin=limits[0], vmax=limits[1])
    points, cells, of_points, of_cells, _ = read(folder / f"{name}_joints_{step:07}.vtu")
    points = points + (magnification - 1) * of_points["displacement"][:, :2]
    lines, state = points[cells.reshape(-1, 2)], of_cells["joint state"]
    mortar = of_cells["joint set ID"] == 1
    axes.add_collection(LineCollection(lines[mortar & (state == 0)], colors="white", linewidths=0.6))
    for kind, colour in COLOURS.items():
        axes.add_collection(LineCollection(lines[state == kind], colors=colour, linewidths=1.8))
    axes.set_title(f"t = {1000 * time:.4g} ms, {np.sum(state == 2)} joints broken", fontsize=10)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=8)
    return drawn


def main():
    name, folder, output = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    steps, height, magnification, array, factor, limits, label = PICTURES[name]
    figure, axes = plt.subplots(1, len(steps), figsize=(5.2 * len(steps) + 0.8, height),
                                layout="constrained", sharey=True)
    for one, step in zip(axes, steps):
        drawn = draw(one, name, folder, step, magnification, array, factor, limits)
    extend = "min" if limits[0] < 0 else "max"
    figure.colorbar(drawn, ax=axes, label=label, shrink=0.8, extend=extend)
    legend = [Line2D([], [], color=COLOURS[1], lw=1.8, label="joint softening"),
              Line2D([], [], color=COLOURS[2], lw=1.8, label="joint broken")]
    if magnification > 1:
        legend.append(Line2D([], [], lw=0, label=f"displacements ×{magnification}"))
    figure.legend(handles=legend, loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    figure.savefig(output, dpi=72)


if __name__ == "__main__":
    main()
