// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSceneDefaults
 * @brief A lamp, a camera and a medium that suit a mesh, for whom gives none.
 *
 * One rule for every mesh, from its bounds alone but for the question whether it is a room:
 *
 * - **Up** is y or z: the one that the given lights shine against; without a light that has a direction the one in which the mesh is
 *   flat (less than half of its other sizes), or for z tall (more than 1.5 times); else y, as VTK's cameras have it.
 * - **A room** has a ceiling over at least 60 % of its ground with space below, and walls on two sides or more; closed all around it is
 *   one only where something stands in it. (A closed box with nothing in it is a thing.)
 * - **Lamp**: a disc. In a room flush with the ceiling in its middle, its radius 9 % of the room's smaller width. Else above the mesh and
 *   to its left, a radius of 7 % and a height above it of half the mesh's largest size, facing it.
 * - **Camera**: of a room with an open side before that, else in a corner of it. Else from the front, 19 degrees to the
 *   right and 13 above, at the distance from which the mesh is seen and lamps that are nearer than four of its largest size.
 * - **Medium**: of a room its bounds. Else the mesh's bounds, wider on each side by 0.8 and higher by 0.2 times the largest
 *   size, and those lamps. SigmaS is 0.7 over the medium's largest size.
 *
 * The exposure needs no default: vtkScatteringImageFilter finds it (AutoExposure).
 *
 * @sa vtkScatteringImageFilter vtkLightWords vtkMeshFiles
 */
#ifndef vtkSceneDefaults_h
#define vtkSceneDefaults_h

#include "ShadowConesWordsModule.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For the inputs

#include <memory> // For what was found
#include <string>
#include <vector>

class vtkAreaLightSource;
class vtkCamera;
class vtkDataObject;

namespace shadowcones
{
struct FoundScene;
}

class SHADOWCONESWORDS_EXPORT vtkSceneDefaults : public vtkObject
{
public:
  static vtkSceneDefaults* New();
  vtkTypeMacro(vtkSceneDefaults, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Which way is up.
  enum UpType
  {
    Automatic = 0,
    X = 1,
    Y = 2,
    Z = 3
  };

  ///@{
  /**
   * Which way is up: an axis, or Automatic as told above. Default: Automatic.
   */
  vtkSetMacro(Up, int);
  vtkGetMacro(Up, int);                                 ///< 0 Automatic, 1 X, 2 Y, 3 Z.
  void SetUpToAutomatic() { this->SetUp(Automatic); }   ///< The axis that lights and mesh speak for.
  void SetUpToX() { this->SetUp(X); }                   ///< x is up.
  void SetUpToY() { this->SetUp(Y); }                   ///< y is up.
  void SetUpToZ() { this->SetUp(Z); }                   ///< z is up.
  ///@}

  /// The mesh: vtkPolyData, or a composite of them. None, or an empty one, stands for a cube of size 1 around the origin.
  void SetMesh(vtkDataObject* mesh);
  /// A light that the user gave, as data. With none the scene is lit by the lamp of PlaceLight().
  void AddLight(vtkDataObject* light);
  void RemoveAllLights(); ///< No light is given from here on.

  /**
   * Look at the mesh and the lights. @return false, with a sentence of GetError(), where one of them is none.
   */
  bool Find();
  /// What went wrong in Find(), as a sentence; empty where nothing did.
  std::string GetError() { return this->Error; }

  int GetFoundUp();           ///< The axis that is up: 1 x, 2 y, 3 z.
  bool IsRoom();              ///< Whether the mesh is a room.
  /// Make a light source the lamp that suits the mesh, of radiance 1.
  void PlaceLight(vtkAreaLightSource* light);
  /// Place a camera for a picture whose width over its height is @p aspect.
  void PlaceCamera(vtkCamera* camera, double aspect);
  void GetMediumBounds(double bounds[6]); ///< The box of the medium: x from, to, y from, to, z from, to.
  double GetSigmaS();                     ///< Its scattering coefficient, 1 / world unit.

protected:
  vtkSceneDefaults();
  ~vtkSceneDefaults() override;

private:
  vtkSceneDefaults(const vtkSceneDefaults&) = delete;
  void operator=(const vtkSceneDefaults&) = delete;

  vtkSmartPointer<vtkDataObject> Mesh;
  std::vector<vtkSmartPointer<vtkDataObject>> Lights;
  int Up = Automatic;
  std::string Error;
  std::unique_ptr<shadowcones::FoundScene> Found;
};

#endif
