// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkConeSetGeometry
 * @brief Surfaces of a cone set, for looking at: the cones, their base discs and their inner (umbra) cones.
 *
 * Each cone becomes a ring of quads between its base and the place where it is cut: at a length, at a plane, or where it leaves a
 * box. A converging cone ends at its tip at the latest. The figures of Hougs and Day, "Piecewise Constant Conic Sections for
 * Accelerated Volume Density Rendering", are drawn like this: cones blue, base discs red, vectors green.
 *
 * Input port 0: vtkPolyData, a cone set as vtkConeSetFilter writes it; "Axis", "BaseRadius" and "HalfAngle" are required.
 *
 * Output port 0: the outer cone surfaces. Output port 1: the base discs, one polygon each. Output port 2: the inner cones, which
 * open or close by InnerHalfAngle and end at their tip: what the base disc alone puts in full shadow. All have point data
 * "Normals" (float 3) and, as cell data, "ConeId" (id) and every point array of the cone set. The pieces of a piece request are
 * ranges of cones.
 *
 * @sa vtkConeSetFilter
 */
#ifndef vtkConeSetGeometry_h
#define vtkConeSetGeometry_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>

namespace shadowcones
{
struct ConeCut;
}

class SHADOWCONESFILTERS_EXPORT vtkConeSetGeometry : public vtkPolyDataAlgorithm
{
public:
  static vtkConeSetGeometry* New();
  vtkTypeMacro(vtkConeSetGeometry, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  enum CutType
  {
    CutLength = 0,
    CutPlane = 1,
    CutBox = 2,
    // Older spelling.
    CUT_LENGTH = CutLength,
    CUT_PLANE = CutPlane,
    CUT_BOX = CutBox
  };
  ///@{
  /// Where cones end. Length: at a height above their base. Plane: where their lines meet a plane. Box: where their lines leave
  /// a box. Default Length.
  vtkSetMacro(Cut, int);
  vtkGetMacro(Cut, int);                             ///< 0 Length, 1 Plane, 2 Box.
  void SetCutToLength() { this->SetCut(CutLength); } ///< End cones at Length above their base.
  void SetCutToPlane() { this->SetCut(CutPlane); }   ///< End cones at the plane through PlaneOrigin with PlaneNormal.
  void SetCutToBox() { this->SetCut(CutBox); }       ///< End cones where they leave BoxBounds.
  ///@}

  ///@{
  /// Length along the axis, world units, 0 or more; with Plane and Box the longest that they leave. 0: the diagonal of the cone
  /// set's bounds (of a single cone ten base radii), with Plane and Box four times that. Default 0.
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double); ///< Length along the axis, world units; 0: automatic.
  ///@}

  ///@{
  /// A point of the plane that cuts. Default (0, 0, 0).
  vtkSetVector3Macro(PlaneOrigin, double);
  /// A point of the plane that cuts, world units.
  vtkGetVector3Macro(PlaneOrigin, double);
  ///@}

  ///@{
  /// Normal of the plane that cuts, any length but 0. Default (0, 1, 0).
  vtkSetVector3Macro(PlaneNormal, double);
  /// Normal of the plane that cuts.
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /// The box that cuts: xmin, xmax, ymin, ymax, zmin, zmax, ascending. Default -1, 1 on each axis.
  vtkSetVector6Macro(BoxBounds, double);
  /// The box that cuts, world units: xmin, xmax, ymin, ymax, zmin, zmax.
  vtkGetVector6Macro(BoxBounds, double);
  ///@}

  ///@{
  /// Lines around a cone, 3..65536. Default 24.
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int); ///< Lines around a cone.
  ///@}

protected:
  vtkConeSetGeometry();
  ~vtkConeSetGeometry() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConeSetGeometry(const vtkConeSetGeometry&) = delete;
  void operator=(const vtkConeSetGeometry&) = delete;

  /// Where cones end, by the parameters. @return false, with a sentence in @p error.
  bool ReadCut(shadowcones::ConeCut& cut, std::string& error) const;

  int Cut = CutLength;
  double Length = 0.0;
  double PlaneOrigin[3] = { 0.0, 0.0, 0.0 };
  double PlaneNormal[3] = { 0.0, 1.0, 0.0 };
  double BoxBounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  int Resolution = 24;
};

#endif
