// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scWarnings.h
 * @brief What a filter says beside its result: which number may be wrong, how far, and what to do.
 *
 * A filter adds sentences while it works and says them at the end, each once a run. The words of all of them are here; each
 * has its line in Documentation/6-errors.md. A function for a sentence gives an empty one where there is nothing to say.
 */
#ifndef scWarnings_h
#define scWarnings_h

#include "ShadowConesDataModule.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkFieldData;

namespace shadowcones
{

struct Box;
struct VisibilityGrid;

class SHADOWCONESDATA_EXPORT Warnings
{
public:
  /// An empty sentence, or one that was added before, is not added.
  void Add(const std::string& sentence);
  void Add(const std::vector<std::string>& sentences);
  /// Say each by vtkWarningMacro of @p speaker, in the order of their coming.
  void Say(vtkAlgorithm* speaker) const;
  const std::vector<std::string>& GetSentences() const { return this->Sentences; }

private:
  std::vector<std::string> Sentences;
};

/// vtkShadowVectorFilter: photons, those that an occluder stopped, and occluders of which none has a vector.
SHADOWCONESDATA_EXPORT std::string NothingInShadow(vtkIdType photons, vtkIdType blocked);
/// @p solidAngle into which they were sent, sr: a narrow bundle may well be stopped whole.
SHADOWCONESDATA_EXPORT std::string NothingLit(vtkIdType photons, vtkIdType blocked, double solidAngle);
/// @p casters one id a triangle, @p vectors one id a vector; negative ids cast no shadow.
SHADOWCONESDATA_EXPORT std::string OccludersWithoutVectors(
  const std::vector<int>& casters, const std::vector<int>& vectors);
/// @p scarce pairs of an occluder and a light with some vectors, but fewer than @p minimum; @p needed photons would do, 0: not known.
SHADOWCONESDATA_EXPORT std::string TooFewVectors(vtkIdType scarce, vtkIdType minimum, vtkIdType needed);
SHADOWCONESDATA_EXPORT std::string TargetNotMet(vtkIdType vectors, vtkIdType target, vtkIdType photons);

/// vtkConeSetFilter. @p names of parameters that were set and that tuning chooses itself.
SHADOWCONESDATA_EXPORT std::string UnusedParameters(const std::string& names);
SHADOWCONESDATA_EXPORT std::string NotProved();
/// @p lacking what the photon paths lack for tuning.
SHADOWCONESDATA_EXPORT std::string NothingToLearnFrom(const std::string& lacking);
SHADOWCONESDATA_EXPORT std::string NoCones(vtkIdType cones, vtkIdType vectors);
/// @p coneIds of each vector the cone that holds it, -1 where none does.
SHADOWCONESDATA_EXPORT std::string OccludersWithoutCone(
  const std::vector<int>& vectors, const std::vector<vtkIdType>& coneIds);

/// Of a tuned set that is to hold the shadow: the share of the held-out blocked light outside its cones.
SHADOWCONESDATA_EXPORT std::string ConesLeak(double leak);

/// Filters that take a cone set for the bounds of the shadow. @p field is the cone set's; a proved set is not doubted.
SHADOWCONESDATA_EXPORT std::string TooManyDiscarded(vtkFieldData* field, bool proved);
/// A set that says that it is proved, of other cones than it has. @p input names it with its port.
SHADOWCONESDATA_EXPORT std::string ConesChanged(const char* input);
SHADOWCONESDATA_EXPORT std::string EmptyConeSet(vtkIdType cones, vtkIdType castingTriangles);

/// vtkConeSetProbe, vtkVisibilityVolume, vtkConeSetAccuracy: places that were asked ("points", "samples").
SHADOWCONESDATA_EXPORT std::string NoPlaceInShadow(
  const char* places, vtkIdType asked, vtkIdType inShadow, vtkIdType cones);
SHADOWCONESDATA_EXPORT std::string NoPlaceLit(const char* places, vtkIdType asked, vtkIdType lit);

/// vtkVisibilityVolume, and vtkScatteringImageFilter in Soft: cells of the extent, or of their bricks, that an edge of the shadow crosses at once.
SHADOWCONESDATA_EXPORT std::string TooCoarse(const VisibilityGrid& grid, const char* remedy);
/// vtkVisibilityVolume: what there is at this time, beyond automatic bounds, which are those of the first time.
SHADOWCONESDATA_EXPORT std::string OutOfFirstBounds(const Box& scene);

/// vtkShadowVolume.
SHADOWCONESDATA_EXPORT std::string OccludersWithoutSurface(vtkIdType without, vtkIdType occluders);
/// Of Projection: of so many solids those that are several in one.
SHADOWCONESDATA_EXPORT std::string SolidsOfSeveralParts(vtkIdType several, vtkIdType occluders);
SHADOWCONESDATA_EXPORT std::string InnerConesNotProved();

/// vtkSunHours: of @p steps, none with the Sun above the @p minimum altitude; the @p highest is, degrees.
SHADOWCONESDATA_EXPORT std::string SunNeverUp(vtkIdType steps, double minimum, double highest);

/// vtkLabelOccluders.
SHADOWCONESDATA_EXPORT std::string TrianglesDropped(vtkIdType dropped, vtkIdType triangles);
/// A mesh, or blocks of meshes, whose points are in single precision and too far out for their polygons' edges.
SHADOWCONESDATA_EXPORT std::string CoarseCoordinates(vtkDataObject* mesh);

/// vtkScatteringImageFilter.
SHADOWCONESDATA_EXPORT std::string MediumNotSeen(vtkIdType pixels, vtkIdType through);
SHADOWCONESDATA_EXPORT std::string NothingSeen(vtkIdType pixels, vtkIdType bright);
SHADOWCONESDATA_EXPORT std::string GoalNotMet(
  vtkIdType pixels, vtkIdType missed, double goal, double worst, int maximumSamples);
/// The same of surfaces, of @p pixels that see one.
SHADOWCONESDATA_EXPORT std::string SurfaceGoalNotMet(
  vtkIdType pixels, vtkIdType missed, double goal, double worst, int maximumSamples);
SHADOWCONESDATA_EXPORT std::string MediumBeyondVolume(double share);
/// Steps of a march that light hardly passes: @p rays that have some, @p opticalDepth of the worst.
SHADOWCONESDATA_EXPORT std::string ThickSteps(vtkIdType rays, vtkIdType pixels, double opticalDepth, int steps);
/// Of an image that asks no rays, at some @p pixels: its light over theirs, and a pixel's error over their mean.
SHADOWCONESDATA_EXPORT std::string NotWhatRaysFind(const char* mode, int pixels, double light, double error);
SHADOWCONESDATA_EXPORT std::string UnusedExposure(double exposure);
/// @p names of what a photon map's medium differs in.
SHADOWCONESDATA_EXPORT std::string OtherMedium(const std::string& names);

/// vtkPhotonMapFilter: the largest share of a wavelength's light that was left at the last bounce.
SHADOWCONESDATA_EXPORT std::string LightCutOff(double share, int maximumBounces);
SHADOWCONESDATA_EXPORT std::string NoPhotonStored(vtkIdType photons);

} // namespace shadowcones

#endif
