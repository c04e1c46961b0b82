// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowPage
 * @brief One HTML file that shows meshes, cones and answers in any browser, from disk, without a network.
 *
 * The file holds everything: the data, and a viewer made of vtk.js (BSD-3-Clause; its licences stand in
 * Modules/Page/viewer/LICENSES.txt). Layers are always there and have a switch each: meshes, and cone sets as the
 * surfaces of their cones. Answers are coloured by an array, such as "Visibility" or "SunHours", with one legend for all; of
 * several answers a slider shows one, so that they are steps of time, of a distance or of whatever their labels say.
 * The colours, cividis, are told apart by every kind of colour vision.
 *
 * Data are copied into the page at once: later changes of a data set do not change it. Points are float 3, world units, less the
 * middle of the first layer, so that scenes far from the origin lose nothing. Of volumes the outer surface is shown; points without
 * cells are shown as points. Points hidden by "vtkGhostType" and values that are not numbers are left out of the legend's range.
 *
 * Memory and size of the file: about 16 bytes a point and 22 a triangle, and 0.6 MB for the viewer.
 *
 * @sa vtkConeSetGeometry vtkConeSetProbe
 */
#ifndef vtkShadowPage_h
#define vtkShadowPage_h

#include "ShadowConesPageModule.h"
#include "vtkObject.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkPolyData;

class SHADOWCONESPAGE_EXPORT vtkShadowPage : public vtkObject
{
public:
  static vtkShadowPage* New();
  vtkTypeMacro(vtkShadowPage, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What stands above the picture. Default ShadowCones.
  vtkSetMacro(Title, std::string);
  vtkGetMacro(Title, std::string); ///< What stands above the picture.
  ///@}

  ///@{
  /// From where the scene is first seen: a direction from its middle, of any length but 0. Default 1, -1.2, 0.8.
  vtkSetVector3Macro(ViewDirection, double);
  /// From where the scene is first seen: a direction from its middle.
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /// Which way is up. Default 0, 0, 1.
  vtkSetVector3Macro(ViewUp, double);
  /// Which way is up.
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  /**
   * Add a surface in one colour. Red, green and blue from 0 to 1; opacity above 0 to 1. False, with a message, where the mesh has no
   * point.
   */
  bool AddMesh(vtkDataSet* mesh, const std::string& name, double red = 0.78, double green = 0.74, double blue = 0.68,
    double opacity = 1.0);

  /**
   * Add the cones of a cone set, as vtkConeSetFilter writes it, each cut at a length in world units; 0: as vtkConeSetGeometry
   * chooses. False, with a message, where there is no cone.
   */
  bool AddCones(vtkPolyData* cones, const std::string& name = "Cones", double length = 0.0);

  /**
   * Add a data set coloured by one of its point or cell arrays: a step of the slider, with what stands beside the slider. All steps have to
   * take the same array; of an array of several components the first is shown. False, with a message, where the array is missing.
   */
  bool AddAnswer(vtkDataSet* answer, const std::string& array, const std::string& label = "");

  /// Forget all layers and answers.
  void Clear();

  /// The page as one string; empty where nothing was added.
  std::string GetPage();

  /// Write the page to a file. False, with a message, where nothing was added or the file cannot be written; the file is then as before.
  bool Write(const std::string& fileName);

protected:
  vtkShadowPage() = default;
  ~vtkShadowPage() override = default;

private:
  vtkShadowPage(const vtkShadowPage&) = delete;
  void operator=(const vtkShadowPage&) = delete;

  /// A data set as the text of a layer; empty where it has no point.
  std::string MakeLayer(vtkDataSet* data, const std::string& name, const std::string& look, const std::string& array);

  std::string Title = "ShadowCones";
  double ViewDirection[3] = { 1.0, -1.2, 0.8 };
  double ViewUp[3] = { 0.0, 0.0, 1.0 };
  double Middle[3] = { 0.0, 0.0, 0.0 };
  double Range[2] = { 1.0, -1.0 };
  std::string Quantity;
  std::vector<std::string> Layers;
  std::vector<std::string> Steps;
};

#endif
