#!/usr/bin/env python3
"""Reads every VTK file below some folders with VTK itself.

Usage: read_vtk.py FOLDER...
Fails if VTK reports an error, if a collection names a file that is not there, or
if nothing was read.
"""
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import vtk


def read(path):
    """Cells and points of a file, and what VTK complained about."""
    poly = path.suffix == ".vtp"
    reader = vtk.vtkXMLPolyDataReader() if poly else vtk.vtkXMLUnstructuredGridReader()
    complaints = []
    reader.AddObserver("ErrorEvent", lambda _, __: complaints.append("error"))
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    return data.GetNumberOfCells(), data.GetNumberOfPoints(), complaints


def main(folders):
    grids = cells = points = 0
    for folder in map(Path, folders):
        for path in sorted(p for e in ("*.vtu", "*.vtp") for p in folder.rglob(e)):
            found_cells, found_points, complaints = read(path)
            if complaints:
                sys.exit(f"VTK cannot read {path}")
            grids += 1
            cells += found_cells
            points += found_points
        for path in folder.rglob("*.pvd"):
            for dataset in ET.parse(path).iter("DataSet"):
                if not (path.parent / dataset.get("file")).is_file():
                    sys.exit(f"{path} names {dataset.get('file')}, which is not there")
    if not (grids and cells and points):
        sys.exit(f"nothing was read: {grids} files, {cells} cells, {points} points")
    print(f"VTK read {grids} files with {cells} cells and {points} points")


if __name__ == "__main__":
    main(sys.argv[1:])
