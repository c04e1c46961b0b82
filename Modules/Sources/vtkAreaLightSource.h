// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAreaLightSource
 * @brief An area light: disc, rectangle, sphere, point or sun.
 *
 * The output shows the light as a mesh, and carries its exact shape in field data. The filters of this project sample
 * the exact shape: Resolution only changes what is seen on the screen. Emission is Lambertian and one-sided: Disc and
 * Rectangle emit on the side of Normal, Sphere emits outward.
 *
 * Input: none.
 *
 * Output: poly data, points in double precision. Disc: one polygon; Rectangle: one quadrilateral; Sphere:
 * quadrilaterals, triangles at the poles; polygons are oriented along the emission. Point: one vertex at Center. Sun:
 * one vertex at Center, which stands for the light on the screen, with its direction as active normals "Normals"
 * (double 3), which transforms turn. Every piece holds the whole light.
 *
 * Field data:
 * - "LightShape" (int 1): 0 Disc, 1 Rectangle, 2 Sphere, 3 Point, 4 Sun
 * - "LightCenter" (double 3, world units)
 * - "LightNormal" (double 3, unit): the side that emits; Sun: the way the light travels; no meaning for Sphere and
 *   Point
 * - "LightAxes" (double, two tuples of 3, world units): Rectangle: from the centre to the middle of two edges, U x V
 *   along the normal; no meaning for other shapes
 * - "LightRadius" (double 1): Disc and Sphere: world units; Sun: half of the angular diameter, radians; no meaning for
 *   other shapes
 * - "LightSpectrum" (double, one value a wavelength sample): see Radiance
 * - "LightWavelengths" (double, nm): the middle of each wavelength sample, equal bins from 400 to 700 nm
 *
 * The exact shape follows a mesh that was moved, turned or scaled as a whole, by vtkTransformPolyDataFilter for one.
 * Where the mesh was cut, stretched or joined with another one its polygons shine instead, and the filter that reads it
 * warns. Several lights are several connections: AddLightConnection.
 *
 * @sa vtkShadowVectorFilter vtkScatteringImageFilter
 */
#ifndef vtkAreaLightSource_h
#define vtkAreaLightSource_h

#include "ShadowConesSourcesModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <map> // for the spectrum

class vtkDataArray;

namespace shadowcones
{
struct Light;
}

class SHADOWCONESSOURCES_EXPORT vtkAreaLightSource : public vtkPolyDataAlgorithm
{
public:
  static vtkAreaLightSource* New();
  vtkTypeMacro(vtkAreaLightSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// Values of Shape and of the field array "LightShape".
  enum ShapeType
  {
    Disc = 0,
    Rectangle = 1,
    Sphere = 2,
    Point = 3,
    Sun = 4
  };

  ///@{
  /**
   * The shape of the light. Sun is infinitely far away: a direction and an angular diameter. Default: Disc.
   */
  vtkSetMacro(Shape, int);
  vtkGetMacro(Shape, int);                                  ///< 0 Disc, 1 Rectangle, 2 Sphere, 3 Point, 4 Sun.
  void SetShapeToDisc() { this->SetShape(Disc); }           ///< A disc with Center, Normal and Radius.
  void SetShapeToRectangle() { this->SetShape(Rectangle); } ///< A rectangle with Center, Normal, Up, Width and Height.
  void SetShapeToSphere() { this->SetShape(Sphere); }       ///< A sphere with Center and Radius, which emits outward.
  void SetShapeToPoint() { this->SetShape(Point); } ///< A point at Center; Radiance is then its intensity, W sr^-1.
  void SetShapeToSun() { this->SetShape(Sun); }     ///< The Sun, along Normal; Radiance is then its irradiance, W m^-2.
  ///@}

  ///@{
  /**
   * The centre of the light, world units, finite. Sun: where its vertex is drawn. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(Center, double);
  /// The centre of the light, world units.
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Disc and Rectangle: the side that emits. Sun: the way the light travels, away from the sun. Any length above 0.
   * Unused by Sphere and Point. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Normal, double);
  /// The side that emits; Sun: the way the light travels.
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * Radius of Disc and Sphere, world units, above 0. Default: 0.5.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double); ///< Radius of Disc and Sphere, world units.
  ///@}

  ///@{
  /**
   * Rectangle: its size across and along Up, world units, above 0. Default: 1 by 1.
   */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);  ///< Rectangle: its size across Up, world units.
  vtkSetMacro(Height, double); ///< Rectangle: its size along Up, world units, above 0. Default: 1.
  vtkGetMacro(Height, double); ///< Rectangle: its size along Up, world units.
  ///@}

  ///@{
  /**
   * Rectangle: the direction in which Height is measured, as far as it lies in the rectangle's plane. Where nothing
   * of it does, the coordinate axis furthest from Normal is taken. Finite. Default: (0, 1, 0).
   */
  vtkSetVector3Macro(Up, double);
  /// Rectangle: the direction in which Height is measured.
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Sun: the angle under which it is seen, degrees, from 0 (hard shadows) to 180. Default: 0.533, the mean from Earth.
   */
  vtkSetMacro(AngularDiameter, double);
  vtkGetMacro(AngularDiameter, double); ///< Sun: the angle under which it is seen, degrees.
  ///@}

  ///@{
  /**
   * Emission, the same at every wavelength sample, at least 0. Disc, Rectangle and Sphere: radiance, W m^-2 sr^-1.
   * Point: radiant intensity, W sr^-1. Sun: irradiance of a plane that faces it, W m^-2, so that AngularDiameter does
   * not change the brightness. Setting it drops the values of SetRadianceSpectrum. Default: 1.
   */
  void SetRadiance(double radiance);
  /// Emission at every wavelength sample that SetRadianceSpectrum has not set, W m^-2 sr^-1.
  vtkGetMacro(Radiance, double);
  ///@}

  ///@{
  /**
   * Emission at one wavelength sample, units as Radiance; indices from 0 to NumberOfWavelengths - 1. Default: Radiance.
   */
  void SetRadianceSpectrum(int index, double radiance);
  /// Emission at the first samples, in place of all that were set.
  void SetRadianceSpectrum(vtkDataArray* radiances);
  void ClearRadianceSpectrum();          ///< Every sample is Radiance again.
  double GetRadianceSpectrum(int index); ///< Emission at one wavelength sample, index from 0, units as Radiance.
  ///@}

  ///@{
  /**
   * Number of wavelength samples, from 1 to 1000: the centres of equal bins from 400 to 700 nm. Default: 7.
   */
  vtkSetMacro(NumberOfWavelengths, int);
  vtkGetMacro(NumberOfWavelengths, int); ///< Number of wavelength samples.
  ///@}

  ///@{
  /**
   * Edges around Disc and Sphere in the mesh that is drawn, from 3 to 4096. Changes no result. Default: 32.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int); ///< Edges around Disc and Sphere in the mesh that is drawn.
  ///@}

protected:
  vtkAreaLightSource();
  ~vtkAreaLightSource() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAreaLightSource(const vtkAreaLightSource&) = delete;
  void operator=(const vtkAreaLightSource&) = delete;

  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  /// @return false, with a sentence in @p error, where that is no light.
  bool MakeLight(shadowcones::Light& light, std::string& error) const;

  int Shape = Disc;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Radius = 0.5;
  double Width = 1.0;
  double Height = 1.0;
  double Up[3] = { 0.0, 1.0, 0.0 };
  double AngularDiameter = 0.533;
  double Radiance = 1.0;
  std::map<int, double> RadianceSpectrum; // samples that differ from Radiance
  int NumberOfWavelengths = 7;
  int Resolution = 32;
};

#endif
