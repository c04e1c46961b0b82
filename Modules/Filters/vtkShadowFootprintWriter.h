// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowFootprintWriter
 * @brief Write the outlines of shadows as GeoJSON (RFC 7946), which map tools open.
 *
 * Closed outlines become polygons: those that lie in no other one of the same light, occluder and class are outer rings, counter-
 * clockwise seen from above (along -z); those that lie in one are its holes, clockwise. Rings end with their first point. Every
 * polygon is a feature with the properties "OccluderName" (where there are names), "OccluderId", "LightId", "ShadowClass" (1 or
 * 2), "Shadow" ("whole shadow", or "umbra") and "Area" (square world units, of the polygon without its holes, seen from
 * above). Coordinates are written as they are: x, y, and z where any is not 0. GeoJSON means longitude and latitude; tools that let
 * you choose a reference system take others, such as metres.
 *
 * Input port 0, vtkPolyData: outlines of vtkShadowFootprints, lines with cell data "ShadowClass", "OccluderId" and "LightId", each
 * optional. Outlines that are open, or have no area seen from above, are left out with a warning. Output: the file alone.
 *
 * @sa vtkShadowFootprints
 */
#ifndef vtkShadowFootprintWriter_h
#define vtkShadowFootprintWriter_h

#include "ShadowConesFiltersModule.h"
#include "vtkWriter.h"

class vtkPolyData;

class SHADOWCONESFILTERS_EXPORT vtkShadowFootprintWriter : public vtkWriter
{
public:
  static vtkShadowFootprintWriter* New();
  vtkTypeMacro(vtkShadowFootprintWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write, as .geojson. An existing file is replaced. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName); ///< The file to write.
  ///@}

protected:
  vtkShadowFootprintWriter() = default;
  ~vtkShadowFootprintWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkShadowFootprintWriter(const vtkShadowFootprintWriter&) = delete;
  void operator=(const vtkShadowFootprintWriter&) = delete;

  char* FileName = nullptr;
};

#endif
