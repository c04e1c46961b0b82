// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkConeSetFilter
 * @brief Group shadow vectors into truncated cones that bound or approximate the soft shadow in space.
 *
 * Hougs and Day, "Piecewise Constant Conic Sections for Accelerated Volume Density Rendering", section 3.2. Seeds are taken in
 * index order. The nearest living vectors of a seed are projected along their mean direction onto the plane fitted to them;
 * going outward, rings of PointsPerRing vectors are accepted until the counts in their sectors vary too much or they leave the
 * plane. The vectors inside are covered and make a cone; seeds that make none are discarded. Nothing is known of the geometry.
 * Results are the same bytes for any number of threads; the pieces of a piece request are ranges of cones (output 0) and of
 * vectors (output 1). Cost is one nearest-neighbour query a seed, near-linear in the number of vectors.
 *
 * Input port 0: vtkPolyData, shadow vectors of vtkShadowVectorFilter or of another tracer. Point data: "Direction" (3, unit)
 * is required; "EmissionPoint" (3) is required where the field data does not carry the light's exact shape; "OccluderId" and
 * "LightId" (int) are optional. Input port 1, optional: photon paths with point data "PathState" (0 lit, 1 blocked),
 * "EmissionPoint", "Direction" and, of several lights, "LightId"; Overspill is measured on them.
 * Input port 2, optional: vtkPolyData, the mesh that casts the shadow; cell data
 * "OccluderId" (int) is optional, cells whose id is negative are receivers. Input port 3, optional, repeatable: the lights, from
 * vtkAreaLightSource or any polygon mesh; without it the exact shape that the vectors carry is taken.
 *
 * With a mesh, and Certify on, the set is proved: each part of an occluder, before each convex part of the light, lies in one
 * cone with all its shadow. Where fitted cones fall short they grow or cones are added. Outside every cone all of the light
 * that shines that way is seen, as a fact and not as a sample's word; see Documentation/8-proved-cones.md.
 *
 * Vectors of several lights are fitted a light at a time, those of "LightId" 0 first: no cone joins vectors of two, and
 * each light has the cones that it would have alone. They share one set of parameters, tuned or not.
 *
 * Output port 0, the cone set: one vertex per cone at the centre of its base. A cone holds the points whose height h above the
 * base along Axis is 0 or more and whose distance from the axis is at most BaseRadius + h tan(HalfAngle). Point data: "Axis"
 * (float 3, unit, away from the light), "BaseRadius" (float, world units), "HalfAngle" (float, radians; negative: converging),
 * "InnerHalfAngle" (float, radians; the umbra of the base disc; negative: it contracts), "Normal" (float 3, unit, of the fitted
 * plane on the side of Axis), "OccluderId" (int, of most of its vectors), "VectorCount" (int, that it was made from), "Planarity" (float, rms distance
 * of its vectors from the plane over BaseRadius), "Overspill" (float 0..1, share of lit photon paths among those through the
 * base disc; -1 without photon paths), "LightId" (int), "ConeOrigin" (int: 0 fitted, 1 grown, 2 added). Field data: every parameter by its name, "Seed" (of the vectors), "NumberOfVectors",
 * "NumberOfCones", "NumberOfDiscarded" (id), "DiscardedFraction" (double), and the lights' exact shapes and
 * "LightFingerprint" where the vectors carry them. Tuned sets hold the parameters that were chosen, and "TuningObjective", "TuningLeak", "TuningLost" (double, on the
 * held-out photons; less is better) and "TuningFits" (int). "TuningChoice" (string) says what was chosen and why. Of the proof:
 * "Certified" (int, 1 where the set is proved), "CertifiedBounds" (double 6: the box in which it holds, infinite: everywhere),
 * "NumberOfProvedParts", "NumberOfGrownCones", "NumberOfAddedCones", "NumberOfOccludersWithoutCone" (id; occluders that touch a
 * light, or see a Sun of nearly 180 degrees: one cone then holds all of CertifiedBounds), "CertificateHash" (unsigned 64 bits, of
 * cones, casters and lights: where another is found the set is not proved).
 *
 * Output port 1: the shadow vectors with all their arrays and point data "ConeId" (id, first cone that holds the vector in its
 * base; -1 where discarded).
 *
 * @warning With ExpansionFraction 1 the cones are bounds: taken as the shadow itself they darken far too much. See
 * Documentation/5-limitations.md.
 * @sa vtkShadowVectorFilter vtkConeSetGeometry vtkScatteringImageFilter
 */
#ifndef vtkConeSetFilter_h
#define vtkConeSetFilter_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>

class vtkFieldData;

namespace shadowcones
{
class Team;
struct ConeSetInputs;
struct ConeSetOptions;
struct PieceRequest;
} // namespace shadowcones

class SHADOWCONESFILTERS_EXPORT vtkConeSetFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkConeSetFilter* New();
  vtkTypeMacro(vtkConeSetFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// Photon paths, input port 1. Optional.
  void SetPhotonPathConnection(vtkAlgorithmOutput* paths);
  void SetPhotonPathData(vtkDataObject* paths); ///< The photon paths as a data object, without a pipeline.
  ///@}

  ///@{
  /// The mesh whose shadow is to be proved, input port 2. Optional.
  void SetMeshConnection(vtkAlgorithmOutput* mesh); ///< Connect the mesh that casts the shadow.
  void SetMeshData(vtkDataObject* mesh);            ///< Give the mesh that casts the shadow.
  ///@}

  ///@{
  /// The lights to prove the shadow for, input port 3, one a connection. Optional where the vectors carry the exact shape.
  void SetLightConnection(vtkAlgorithmOutput* light); ///< Connect one light in place of all.
  void SetLightData(vtkDataObject* light);            ///< Give one light in place of all.
  void AddLightConnection(vtkAlgorithmOutput* light); ///< Connect one more light.
  void AddLightData(vtkDataObject* light);            ///< Give one more light.
  void RemoveAllLights();                             ///< Disconnect all lights.
  ///@}

  enum TuningType
  {
    Manual = 0,
    Conservative = 1,
    Preview = 2,
    Soft = 3,
    Automatic = 4,
    // Older spelling.
    MANUAL = Manual,
    CONSERVATIVE = Conservative,
    PREVIEW = Preview,
    SOFT = Soft,
    AUTOMATIC = Automatic
  };
  ///@{
  /// How the parameters below are chosen. Manual: as they are set. Automatic: Conservative where photon paths are connected, else
  /// large overlapping cones from the light's geometry; with a mesh, cones around parts of it where those are tighter
  /// ("TuningChoice" says which and by how much).
  /// Conservative, Preview and Soft need photon paths and choose everything but NumberOfSectors and PlanarityThreshold, by
  /// fitting three quarters of the photons and measuring on the rest (section 6.1). Conservative: bounds, the least leak with few
  /// cones, no vector left over; with a mesh, which closes what leaks, the largest share of blocked light with at most 150 cones
  /// a light. Preview: the shadow itself, bases trimmed by the photon paths and ExpansionFraction so that lit light lost inside the cones equals blocked light leaking outside. Soft: base discs as surfels for vtkConeSetProbe,
  /// RadiusScale so that lit paths caught equal blocked paths missed, then the best intersection over union. Where the paths
  /// have nothing to teach a warning says so and bounds are made as Automatic does without paths. Default Automatic.
  vtkSetMacro(Tuning, int);
  vtkGetMacro(Tuning, int);                             ///< 0 Manual, 1 Conservative, 2 Preview, 3 Soft, 4 Automatic.
  void SetTuningToManual() { this->SetTuning(Manual); } ///< Every parameter as it is set.
  /// Bounds: the least leak with few cones. Needs photon paths.
  void SetTuningToConservative() { this->SetTuning(Conservative); }
  /// The shadow itself, as much lost as leaked. Needs photon paths.
  void SetTuningToPreview() { this->SetTuning(Preview); }
  void SetTuningToSoft() { this->SetTuning(Soft); } ///< Base discs as surfels for vtkConeSetProbe. Needs photon paths.
  void SetTuningToAutomatic() { this->SetTuning(Automatic); } ///< Bounds from what is connected.
  ///@}

  ///@{
  /// p1: nearest vectors that a cone is built from, 3..1000000 and at least MinimumVectorsPerCone. Default 100.
  vtkSetMacro(NumberOfNeighbors, int);
  vtkGetMacro(NumberOfNeighbors, int); ///< Nearest vectors that a cone is built from.
  ///@}

  ///@{
  /// p2: angular bins around the seed, 1..65536. Default 20.
  vtkSetMacro(NumberOfSectors, int);
  vtkGetMacro(NumberOfSectors, int); ///< Angular bins around the seed.
  ///@}

  ///@{
  /// p3: vectors in each ring, at least 1 and below NumberOfNeighbors. Default 16.
  vtkSetMacro(PointsPerRing, int);
  vtkGetMacro(PointsPerRing, int); ///< Vectors in each ring.
  ///@}

  ///@{
  /// p4: fewer vectors make no cone, at least 1 and at most the seed and the whole rings that fit among NumberOfNeighbors.
  /// Default 20.
  vtkSetMacro(MinimumVectorsPerCone, int);
  vtkGetMacro(MinimumVectorsPerCone, int); ///< Fewer vectors than this make no cone.
  ///@}

  ///@{
  /// Largest variance over mean of a ring's sector counts, 0 or more. About 1 is even; 1.25 is strict, 1.6 to 2 covers more.
  /// Default 1.6.
  vtkSetMacro(VarianceThreshold, double);
  vtkGetMacro(VarianceThreshold, double); ///< Largest variance over mean of a ring's sector counts.
  ///@}

  ///@{
  /// Largest rms distance of a ring's vectors from the plane over the ring's radius (section 3.2.3); 0: no test. A test makes fewer
  /// and flatter cones and costs recall where thin parts lie behind one another. Default 0.
  vtkSetMacro(PlanarityThreshold, double);
  /// Largest rms distance of a ring from the plane over its radius; 0: no test.
  vtkGetMacro(PlanarityThreshold, double);
  ///@}

  ///@{
  /// Multiply the base radius by the cosine between plane normal and axis (figure 5). Off for bounds. Default on.
  vtkSetMacro(CosineCorrection, bool);
  /// Whether the base radius is multiplied by the cosine between plane normal and axis.
  vtkGetMacro(CosineCorrection, bool);
  /// Multiply the base radius by the cosine, as in figure 5.
  vtkBooleanMacro(CosineCorrection, bool); ///< Leave the base radius as it is: for bounds.
  ///@}

  enum ExpansionType
  {
    MaximumDeviation = 0,
    RadiusRatio = 1,
    LightGeometry = 2,
    // Older spelling.
    MAXIMUM_DEVIATION = MaximumDeviation,
    RADIUS_RATIO = RadiusRatio,
    LIGHT_GEOMETRY = LightGeometry
  };
  ///@{
  /// What the half angle comes from. MaximumDeviation: the largest angle between a vector and their mean (section 3.2.2).
  /// RadiusRatio: the disc of the vectors' ends over the base; finds converging sets. LightGeometry: the outer penumbra cone of
  /// the base disc under the light, which needs no sampling. Default MaximumDeviation.
  vtkSetMacro(Expansion, int);
  vtkGetMacro(Expansion, int); ///< 0 MaximumDeviation, 1 RadiusRatio, 2 LightGeometry.
  /// The largest angle between a vector and their mean.
  void SetExpansionToMaximumDeviation() { this->SetExpansion(MaximumDeviation); }
  /// From the disc of the vectors' ends over the base.
  void SetExpansionToRadiusRatio() { this->SetExpansion(RadiusRatio); }
  /// The outer penumbra cone of the base disc under the light.
  void SetExpansionToLightGeometry() { this->SetExpansion(LightGeometry); }
  ///@}

  ///@{
  /// HalfAngle is this share of the angle found, 0..1 (section 3.3.1). Default 1.
  vtkSetMacro(ExpansionFraction, double);
  vtkGetMacro(ExpansionFraction, double); ///< HalfAngle is this share of the angle found, 0..1.
  ///@}

  ///@{
  /// Factor on the base radius, above 0. Default 1.
  vtkSetMacro(RadiusScale, double);
  vtkGetMacro(RadiusScale, double); ///< Factor on the base radius.
  ///@}

  ///@{
  /// Shrink each base to the largest radius inside which at most this share of the photon paths is lit, 0..1; 1: off. Needs photon
  /// paths. Smaller values keep bases from spilling over edges (figure 3b) and cost recall where parts are thin. Default 1.
  vtkSetMacro(MaximumOverspill, double);
  vtkGetMacro(MaximumOverspill, double); ///< Largest share of lit photon paths through a base, 0..1; 1: off.
  ///@}

  ///@{
  /// On: neighbours come from all vectors and covered ones only stop being seeds, so that cones overlap: better bounds. Off:
  /// covered vectors leave the set, as in the paper. Default off.
  vtkSetMacro(Overlap, bool);
  vtkGetMacro(Overlap, bool); ///< Whether cones may overlap.
  /// Let cones overlap: better bounds.
  vtkBooleanMacro(Overlap, bool); ///< Covered vectors leave the set, as in the paper.
  ///@}

  enum LeftoversType
  {
    Discard = 0,
    Cover = 1,
    // Older spelling.
    DISCARD = Discard,
    COVER = Cover
  };
  ///@{
  /// What becomes of vectors that no base took. Discard: they have no cone (section 3.2.1). Cover: they get cones of their own,
  /// each around a vector and its nearest ones on the same occluder. Default Cover.
  vtkSetMacro(Leftovers, int);
  vtkGetMacro(Leftovers, int); ///< 0 Discard, 1 Cover.
  /// Leave vectors that no base took without a cone, as in the paper.
  void SetLeftoversToDiscard() { this->SetLeftovers(Discard); }
  /// Give every vector a cone.
  void SetLeftoversToCover() { this->SetLeftovers(Cover); }
  ///@}

  ///@{
  /// Where a mesh is connected, let cones grow and add some until they are proved to hold all of its shadow. Acts with Tuning
  /// Manual, Conservative and Automatic; Preview and Soft sets stay as they are. Default on.
  vtkSetMacro(Certify, bool);
  vtkGetMacro(Certify, bool); ///< Whether a connected mesh makes proved sets.
  /// Prove sets where a mesh is connected.
  vtkBooleanMacro(Certify, bool); ///< Leave sets as they are fitted.
  ///@}

  /// Set every parameter as the paper has it (section 3.2): Tuning Manual, p1 to p4, CosineCorrection on, MaximumDeviation, no
  /// overlap, leftovers discarded, Certify off.
  void SetToPaper();

protected:
  vtkConeSetFilter();
  ~vtkConeSetFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConeSetFilter(const vtkConeSetFilter&) = delete;
  void operator=(const vtkConeSetFilter&) = delete;

  struct Outcome; // what the filter made

  /// Names of the fitting parameters that were set and that tuning chooses itself.
  std::string ParametersNotUsed() const;
  /// What is wrong with the parameters, or with what is connected, as a sentence; empty where nothing is.
  std::string CheckRequest(bool hasPaths) const;
  shadowcones::ConeSetOptions Options() const;
  /// @return false where aborted.
  bool Fit(const shadowcones::ConeSetInputs& inputs, bool prove, shadowcones::Team* team, Outcome& outcome);
  void WriteCones(const Outcome& outcome, const shadowcones::ConeSetInputs& inputs,
    const shadowcones::PieceRequest& piece, vtkFieldData* inputData, vtkPolyData* output) const;

  int Tuning = Automatic;
  int NumberOfNeighbors = 100;
  int NumberOfSectors = 20;
  int PointsPerRing = 16;
  int MinimumVectorsPerCone = 20;
  double VarianceThreshold = 1.6;
  double PlanarityThreshold = 0.0;
  bool CosineCorrection = true;
  int Expansion = MaximumDeviation;
  double ExpansionFraction = 1.0;
  double RadiusScale = 1.0;
  double MaximumOverspill = 1.0;
  bool Overlap = false;
  int Leftovers = Cover;
  bool Certify = true;
};

#endif
