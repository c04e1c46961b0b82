// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DataBytes.h
 * @brief Data objects as named strings of bytes, to be compared.
 */
#ifndef DataBytes_h
#define DataBytes_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <map>
#include <string>

namespace invariants
{

using NamedBytes = std::map<std::string, std::string>;

/// Everything that makes the data: structure, coordinates and all arrays; but for field data that are timings.
NamedBytes BytesOf(vtkDataObject* data);

/**
 * The cells one after the other, each with the coordinates and point data of its corners and with its cell data: what pieces
 * can be joined from, whichever way they share points. Images: one cell a point.
 */
NamedBytes CellSoup(vtkDataObject* data);

/// The same of every output of a filter.
NamedBytes BytesOfOutputs(vtkAlgorithm* filter);

/// Times of change of the data object, its coordinates, cells and arrays.
std::map<std::string, vtkMTimeType> TimesOf(vtkDataObject* data);

/// Names under which the two differ; empty where they are the same.
std::string Difference(const NamedBytes& a, const NamedBytes& b);

/// No points, no cells, no arrays with values (images: no arrays).
bool IsEmpty(vtkDataObject* data);
/// The same of all outputs of a filter.
bool AreOutputsEmpty(vtkAlgorithm* filter);

} // namespace invariants

#endif
