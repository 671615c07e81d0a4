"""Reads the outputs of a run with other people's readers and compares the values.

The d3plot family is opened with lasso-python, every grid of the collection with VTK and with
meshio. What they read is compared with the full-precision states of the same run, with each
other, and with the collection. Prints a table of largest differences; exits with 1 when one is
larger than allowed or something does not fit together.

A state file `state_<N>.txt` holds the state after N completed steps. Outputs of step index N
are written before that step's update and therefore show the same coordinates and velocities.
The step index of an output is the number that ends the name of its grid.
"""

import argparse
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

import meshio
import numpy as np
from lasso.dyna import D3plot
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

VTK_TRIANGLE, VTK_TETRA = 5, 10
CONTINUUM = {VTK_TRIANGLE: ("triangle", 3), VTK_TETRA: ("tetra", 4)}


class Checks:
    """Collects largest differences and failures."""

    def __init__(self, tolerance):
        self.tolerance = tolerance
        self.rows = {}
        self.failures = []

    def fail(self, text):
        self.failures.append(text)

    def same(self, what, found, expected):
        if found != expected:
            self.fail(f"{what}: {found}, but {expected} expected")

    def close(self, what, found, expected):
        """Compares arrays relative to the largest expected value; NaN matches NaN."""
        found, expected = np.asarray(found), np.asarray(expected)
        if found.shape != expected.shape:
            self.fail(f"{what}: shape {found.shape}, but {expected.shape} expected")
            return
        entries, difference, scale, values, _ = self.rows.get(what, (0, 0.0, 0.0, 0, True))
        if found.size:
            finite = np.isfinite(expected)
            if not np.array_equal(found[~finite], expected[~finite], equal_nan=True):
                self.fail(f"{what}: not the same values are infinite or NaN")
            if finite.any():
                found = found[finite].astype(float)
                expected = expected[finite].astype(float)
                # A reader that yields NaN for a number must not pass.
                here = np.max(np.nan_to_num(np.abs(found - expected), nan=np.inf))
                difference = max(difference, float(here))
                scale = max(scale, float(np.max(np.abs(expected))))
        good = difference <= self.tolerance * scale
        self.rows[what] = (entries + 1, difference, scale, values + found.size, good)

    def report(self):
        width = max([len(what) for what in self.rows], default=10)
        print(f"{'compared':{width}}  outputs     values  largest value  largest difference")
        for what, (entries, difference, scale, values, good) in self.rows.items():
            mark = "" if good else "  <-- too large"
            print(f"{what:{width}}  {entries:7d}  {values:9d}  {scale:13.6e}  {difference:18.6e}{mark}")
            if not good:
                self.failures.append(f"{what}: difference {difference:.3e} of {scale:.3e}")
        for failure in self.failures:
            print(f"FAILED: {failure}")
        return 1 if self.failures else 0


def read_state(path):
    """Coordinates and velocities of a state file, three components each."""
    nodes = []
    with open(path, encoding="ascii") as lines:
        for line in lines:
            if line.startswith("# element"):
                break
            if not line.startswith("#") and line.strip():
                nodes.append([float(number) for number in line.split()])
    nodes = np.array(nodes)
    # id, then position, velocity and force, then mass, boundary flag and property
    dimensions = (nodes.shape[1] - 4) // 3
    vectors = [nodes[:, 1 + i * dimensions : 1 + (i + 1) * dimensions] for i in range(2)]
    missing = np.zeros((len(nodes), 3 - dimensions))
    return [np.hstack([vector, missing]) for vector in vectors]


def read_collection(path):
    """Per time: step index, and the grid of each part."""
    outputs = {}
    for entry in ElementTree.parse(path).getroot().iter("DataSet"):
        file = path.parent / entry.get("file")
        step = re.search(r"_(\d+)$", file.stem)
        if step is None:
            raise SystemExit(f"{file} does not end with a step index")
        key = (float(entry.get("timestep")), int(step.group(1)))
        outputs.setdefault(key, {})[int(entry.get("part"))] = file
    return sorted(outputs.items())


def read_with_vtk(path):
    """The grid as arrays, by VTK's own reader."""
    reader = vtkXMLUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    reader.Update()
    if errors:
        raise SystemExit(f"VTK cannot read {path}")
    grid = reader.GetOutput()

    def arrays(data):
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        return {name: vtk_to_numpy(data.GetArray(name)) for name in names}

    cells = grid.GetCells()
    tensors = grid.GetCellData().GetArray("stress")
    return {
        "points": vtk_to_numpy(grid.GetPoints().GetData()),
        "point": arrays(grid.GetPointData()),
        "cell": arrays(grid.GetCellData()),
        "field": arrays(grid.GetFieldData()),
        "types": vtk_to_numpy(grid.GetCellTypes()) if grid.GetNumberOfCells() else np.zeros(0),
        "connectivity": vtk_to_numpy(cells.GetConnectivityArray()),
        "stress components": tensors
        and [tensors.GetComponentName(i) for i in range(tensors.GetNumberOfComponents())],
    }


def as_in_file(block):
    """The points of meshio's cells in VTK's order: meshio turns wedges over."""
    return block.data[:, [0, 2, 1, 3, 5, 4]] if block.type == "wedge" else block.data


def check_meshio(checks, path, grid):
    """Everything meshio reads must be what VTK reads."""
    mesh = meshio.read(path)
    checks.close("meshio: points, against VTK", mesh.points, grid["points"])
    cells = [as_in_file(block).ravel() for block in mesh.cells]
    connectivity = np.concatenate(cells) if cells else np.zeros(0)
    checks.close("meshio: connectivity, against VTK", connectivity, grid["connectivity"])
    checks.same(f"{path}: point arrays", sorted(mesh.point_data), sorted(grid["point"]))
    for name, values in mesh.point_data.items():
        checks.close(f"meshio: {name}, against VTK", values, grid["point"][name])
    checks.same(f"{path}: cell arrays", sorted(mesh.cell_data), sorted(grid["cell"]))
    for name, blocks in mesh.cell_data.items():
        if blocks:
            values = np.concatenate(blocks)
            checks.close(f"meshio: {name}, against VTK", values, grid["cell"][name])


def single(values):
    return np.asarray(values).astype(np.float32)


def continuum_of_d3plot(d3plot):
    """Connectivity and stresses of triangles or tetrahedra, joints left out."""
    for kind, corners in [("shell", 3), ("solid", 4)]:
        nodes = d3plot.arrays.get(f"element_{kind}_node_indexes", np.zeros((0, 8)))
        if len(nodes):
            chosen = (nodes[:, corners:] == nodes[:, [corners - 1]]).all(axis=1)
            stresses = d3plot.arrays.get(f"element_{kind}_stress")
            if stresses is not None:
                stresses = stresses[:, chosen, 0, :]
            return nodes[chosen][:, :corners], stresses
    return None, None


def check_d3plot(checks, d3plot, outputs, states):
    """What lasso reads against the states and the collection."""
    arrays = d3plot.arrays
    times = arrays["timesteps"]
    checks.same("d3plot: number of states", len(times), len(outputs))
    expected = single([time for (time, _), _ in outputs])
    checks.close("lasso: times, against the collection", times, expected)
    for index, ((_, step), _) in enumerate(outputs[: len(times)]):
        if step in states:
            coordinates, velocities = read_state(states[step])
            # lasso calls the current coordinates displacement
            found = arrays["node_displacement"][index]
            checks.close("lasso: coordinates, against states", found, single(coordinates))
            found = arrays["node_velocity"][index]
            checks.close("lasso: velocities, against states", found, single(velocities))


def check_grids(checks, outputs, states, d3plot):
    """What VTK and meshio read against the states and the d3plot."""
    connectivity, stresses = continuum_of_d3plot(d3plot) if d3plot else (None, None)
    for index, ((time, step), parts) in enumerate(outputs):
        for part, path in sorted(parts.items()):
            grid = read_with_vtk(path)
            if len(grid["types"]):  # meshio 5.3.5 cannot read grids without cells
                check_meshio(checks, path, grid)
            checks.close("VTK: TimeValue, against the collection", grid["field"]["TimeValue"], [time])
            if step in states:
                coordinates, velocities = read_state(states[step])
                checks.close("VTK: coordinates, against states", grid["points"], coordinates)
                velocity = grid["point"]["velocity"]
                checks.close("VTK: velocities, against states", velocity, velocities)
            if part != 0 or d3plot is None:
                continue
            kinds = set(grid["types"].tolist())
            if len(kinds) != 1 or not kinds <= set(CONTINUUM):
                checks.fail(f"{path}: cells of types {kinds}")
                continue
            _, corners = CONTINUUM[kinds.pop()]
            found = grid["connectivity"].reshape(-1, corners)
            checks.close("VTK: connectivity, against lasso", found, connectivity)
            names = grid["stress components"]
            checks.same(f"{path}: stress components", names, ["XX", "YY", "ZZ", "XY", "YZ", "XZ"])
            if stresses is None:
                checks.fail("lasso finds no stresses in the d3plot")
            elif index < len(stresses):
                found = single(grid["cell"]["stress"])
                checks.close("VTK: stresses, against lasso", found, stresses[index])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=Path, metavar="RUN_DIR", help="folder of the run; other paths are relative to it")
    parser.add_argument("--d3plot", type=Path, help="first file of the d3plot family")
    parser.add_argument("--pvd", type=Path, required=True, help="collection of the run")
    parser.add_argument("--states", type=Path, default=Path("."), help="folder of the state_<N>.txt")
    parser.add_argument("--every", type=int, default=1, help="steps per output, where grids are numbered by output")
    parser.add_argument("--tolerance", type=float, default=0.0, help="allowed difference relative to the largest value (default: none)")
    options = parser.parse_args()

    outputs = read_collection(options.run / options.pvd)
    outputs = [((time, step * options.every), parts) for (time, step), parts in outputs]
    found = (options.run / options.states).glob("state_*.txt")
    states = {int(path.stem.removeprefix("state_")): path for path in found}
    d3plot = D3plot(str(options.run / options.d3plot)) if options.d3plot else None

    checks = Checks(options.tolerance)
    compared = sorted(states.keys() & {step for (_, step), _ in outputs})
    print(f"{len(outputs)} outputs, full-precision states of steps {compared}")
    if not compared:
        checks.fail("no state file belongs to an output")
    if d3plot:
        check_d3plot(checks, d3plot, outputs, states)
    check_grids(checks, outputs, states, d3plot)
    sys.exit(checks.report())


if __name__ == "__main__":
    main()
