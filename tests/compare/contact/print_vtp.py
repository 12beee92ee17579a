# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints a .vtp file as VTK's own reader understands it, as JSON. Exit status 77 where VTK is not installed."""
import json
import sys

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    sys.exit(77)


def numbers(array):
    return [array.GetComponent(i, k) for i in range(array.GetNumberOfTuples())
            for k in range(array.GetNumberOfComponents())]


def arrays(data):
    return {data.GetArrayName(i): numbers(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}


reader = vtkXMLPolyDataReader()
errors = []
reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
reader.SetFileName(sys.argv[1])
reader.Update()
data = reader.GetOutput()
cells = [[data.GetCell(c).GetPointId(k) for k in range(data.GetCell(c).GetNumberOfPoints())]
         for c in range(data.GetNumberOfCells())]
json.dump({"errors": len(errors),
           "points": numbers(data.GetPoints().GetData()) if data.GetNumberOfPoints() else [],
           "vertices": data.GetNumberOfVerts(),
           "lines": data.GetNumberOfLines(),
           "polygons": data.GetNumberOfPolys(),
           "cells": cells,
           "point_data": arrays(data.GetPointData()),
           "cell_data": arrays(data.GetCellData())}, sys.stdout)
