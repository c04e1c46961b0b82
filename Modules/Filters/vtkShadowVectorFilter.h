// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVectorFilter
 * @brief Shadow vectors: where light that an occluder stopped would have gone on.
 *
 * Photons leave the light, stratified over its area and over the directions in which the occluders' bounds are seen. Where an
 * occluder stops one, a shadow vector is stored: by default on the occluder's back side, with the photon's direction (Hougs
 * and Day, "Piecewise Constant Conic Sections for Accelerated Volume Density Rendering", section 3.1). Every later occluder
 * along the path stores one too. Photon i is a pure function of (Seed, i): results are the same bytes for any number of
 * threads, and the pieces of a piece request are ranges of photons whose union is the whole.
 *
 * Input port 0: vtkPolyData of triangles with cell array "OccluderId" (int), as vtkLabelOccluders writes it. Cells whose id is
 * negative are receivers: they end a path and take shadow photons, but store no vectors. Input port 1: the lights, each
 * from vtkAreaLightSource, or any polygon mesh, which then emits from every face along its normal.
 *
 * Several lights (one a connection, or a block of a composite) share the photons by power: pi x area x radiance for
 * discs, rectangles, spheres and meshes, 4 pi x intensity for points, and for a Sun its irradiance x the area of the
 * occluders' bounds as it sees them, means over wavelengths; but none that shines gets less than an eighth of an equal
 * share. A light's photons are the first ones of those that it has alone, and "Power" makes up for their number.
 *
 * Output port 0, shadow vectors, one vertex each (points in double precision). Point data: "Direction" (float 3, unit, away
 * from the light), "Normal" (float 3, unit; BackSide: outward where the light would come out; HitPoint: where it goes in),
 * "OccluderId" (int), "EmissionPoint" (double 3; Sun: a point towards it, beyond the occluders), "PathLength" (float, world
 * units, emission point to the vector's point), "Thickness" (float, world units, entry to exit; 0 for open sheets),
 * "PhotonIndex" (id), "LightId" (int, counts the lights in the order of connections and blocks).
 *
 * Output port 1, photon paths, one vertex each at the path's first hit (lit paths: at the receiver, or where they leave the
 * bounds). Point data: "PathState" (int: 0 lit, 1 blocked), "OccluderId" (int, of the first hit; -1 where lit),
 * "EmissionPoint" (double 3), "Direction" (float 3), "Power" (float, W, mean over the wavelength samples: the surface photon
 * map), "PhotonIndex" (id), "LightId" (int).
 *
 * Output port 2, shadow photons (Jensen and Christensen 1995), one vertex each on the next surface behind the first occluder.
 * Point data: "Normal" (float 3, of that surface), "Direction" (float 3), "Power" (float, W, negative: the flux that is
 * missing), "OccluderId" (int, of the caster), "ReceiverId" (int, occluder id of the surface), "PhotonIndex" (id),
 * "LightId" (int).
 *
 * Field data of all outputs: "NumberOfPhotons" (id, emitted in all), "MeanSolidAngle" (double, sr, into which they were aimed),
 * "PhotonsOfLights" (id, of these, one value a light), "Seed", "Storage" (int), "LightFingerprint" (unsigned 64-bit,
 * one value a light, of its geometry), and the lights' exact shapes ("LightShape" and its companions, one tuple a
 * light) where there are.
 *
 * @warning Memory is about 250 bytes a photon while tracing.
 * @sa vtkAreaLightSource vtkLabelOccluders vtkConeSetFilter
 */
#ifndef vtkShadowVectorFilter_h
#define vtkShadowVectorFilter_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory>
#include <string>

namespace shadowcones
{
class PreparedUser;
struct PreparedMesh;
struct SceneLights;
} // namespace shadowcones

class SHADOWCONESFILTERS_EXPORT vtkShadowVectorFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkShadowVectorFilter* New();
  vtkTypeMacro(vtkShadowVectorFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// The light, input port 1. Required.
  /// Several lights: one a connection, or a block of a composite, all with the same wavelengths. Set replaces all of
  /// them.
  void SetLightConnection(vtkAlgorithmOutput* light);
  void SetLightData(vtkDataObject* light);            ///< The light as a data object, without a pipeline.
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more light.
  void AddLightData(vtkDataObject* light);            ///< One more light as a data object, without a pipeline.
  void RemoveAllLights();                             ///< No light is connected from here on.
  ///@}

  ///@{
  /// Photons to emit, 0 or more; used where TargetNumberOfVectors is 0. Default 40000.
  vtkSetMacro(NumberOfPhotons, vtkIdType);
  vtkGetMacro(NumberOfPhotons, vtkIdType); ///< Photons to emit where TargetNumberOfVectors is 0.
  ///@}

  ///@{
  /// Emit photons until so many vectors are stored (the last photon may store a few more, aimed ones some per cent); 0: emit NumberOfPhotons.
  /// Gives up, with a warning, after 1000 photons a vector. Default 0.
  vtkSetMacro(TargetNumberOfVectors, vtkIdType);
  vtkGetMacro(TargetNumberOfVectors, vtkIdType); ///< Vectors to store; 0: as many as NumberOfPhotons give.
  ///@}

  ///@{
  /// Vectors that every occluder is to have of every light, 0 or more; 0: off. Photons are aimed at occluders that would have
  /// fewer, small or far ones, with some lit ones beside them; "Power" stays right. Never more than an even share of the target,
  /// or of half the photons, of which they are taken. Where hardly any photon would meet an occluder every one gets its even
  /// share. An occluder that light does not reach has none. Default 32.
  vtkSetMacro(MinimumVectorsPerOccluder, int);
  vtkGetMacro(MinimumVectorsPerOccluder, int); ///< Vectors that every occluder is to have of every light; 0: off.
  ///@}

  enum StorageType
  {
    BackSide = 0,
    HitPoint = 1,
    // Older spelling.
    BACK_SIDE = BackSide,
    HIT_POINT = HitPoint
  };
  ///@{
  /// Where a vector is stored. BackSide: at the exit of the solid that was entered, at the hit itself where the occluder is an
  /// open sheet (the paper's choice). HitPoint: where the path first meets the occluder, so that cones bound the shadow inside
  /// the occluder too. Default HitPoint.
  vtkSetMacro(Storage, int);
  vtkGetMacro(Storage, int); ///< 0 BackSide, 1 HitPoint.
  /// Store vectors where light would leave the occluder, as in the paper.
  void SetStorageToBackSide() { this->SetStorage(BackSide); }
  /// Store vectors where light meets the occluder: for bounds.
  void SetStorageToHitPoint() { this->SetStorage(HitPoint); }
  ///@}

  ///@{
  /// Any integer: chooses the photons. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Number that chooses the photons.
  ///@}

  /// Store vectors as the paper does (section 3.1): at the back side of the occluder, of photons aimed at all occluders alike.
  void SetToPaper()
  {
    this->SetStorageToBackSide();
    this->SetMinimumVectorsPerOccluder(0);
  }

  ///@{
  /// The mesh that photons are sent at and its search tree, kept for the next photons and for other filters, see
  /// vtkScatteringImageFilter.
  vtkObject* GetPreparedScene();
  vtkTypeInt64 GetPreparedMemory();        ///< Bytes that the scene takes.
  /// Send photons at the mesh of another filter's scene. Default: a scene of its own.
  void SetPreparedScene(vtkObject* scene);
  vtkIdType GetNumberOfPreparations();     ///< Meshes and trees that were built here.
  void ReleasePreparedScene();             ///< Keep nothing until the next run.
  ///@}

protected:
  vtkShadowVectorFilter();
  ~vtkShadowVectorFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShadowVectorFilter(const vtkShadowVectorFilter&) = delete;
  void operator=(const vtkShadowVectorFilter&) = delete;

  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  /// @return false, with a sentence in @p error, where something is missing or wrong.
  bool ReadInputs(vtkInformationVector** inputVector, std::shared_ptr<const shadowcones::PreparedMesh>& prepared,
    shadowcones::SceneLights& lights, std::string& error);

  vtkIdType NumberOfPhotons = 40000;
  vtkIdType TargetNumberOfVectors = 0;
  int MinimumVectorsPerOccluder = 32;
  int Storage = HitPoint;
  int Seed = 1;

  std::unique_ptr<shadowcones::PreparedUser> Prepared;
};

#endif
