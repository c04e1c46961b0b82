// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkConeSetAccuracy
 * @brief The cone accuracy overlay: how far to trust a cone set, held against the mesh at sample points.
 *
 * From each sample point rays look at NumberOfLightSamples points of the light, stratified and turned from sample to
 * sample: that is the truth. The cones predict: a sample inside any cone is in shadow, one inside the inner cone of a
 * cone that holds it is in umbra. Both are counted and compared, with 95 % confidence intervals. Samples are given, or
 * drawn evenly in a box (an Owen-scrambled Sobol sequence). Results are the same bytes for any number of threads; the
 * pieces of a piece request are ranges of samples (output 0), of cones (output 4), and piece 0 holds the tables.
 *
 * Input port 0, optional: vtkDataSet whose points are the samples. A point array "ShadowClass" (0 lit, 1 penumbra, 2
 * umbra, from any other classifier) is held against the same truth; points that are hidden are no samples. Input port 1: vtkPolyData, a cone set. Input port
 * 2: the mesh, vtkPolyData or composite data of them, which are joined; cell data "OccluderId" is optional, cells whose id is negative are receivers, which
 * block nothing here. Input port 3: the light, from vtkAreaLightSource or any polygon mesh.
 *
 * Output port 0, samples, one vertex each, with the point data of input port 0. Point data: "Truth" (float 0..1,
 * visible fraction of the light; 1 where the light does not shine to), "Prediction" (unsigned char: 0 lit, 1 penumbra,
 * 2 umbra), "Confusion" (unsigned char: 0 true negative, 1 true positive, 2 false positive, 3 false negative; positive
 * is shadowed: Truth < 1), "ConeId" (id, the first cone that holds it, -1 where none), "OccluderId" (int, the one that
 * most of the blocked light passed last; where none is blocked that of the cone; -1 for true negatives), "Depth"
 * (float, world units: the height above the base of that cone; for false negatives the mean distance to the occluder;
 * -1 for true negatives).
 *
 * Output port 1, vtkTable, the summary, one row a quantity: "Quantity" (string), "Value", "Low", "High" (double; the
 * confidence interval). Samples that the light does not shine to are left out. TP, FP, FN: numbers of samples of a
 * Confusion class. A quantity 0 / 0 is NaN.
 *   - Recall = TP / (TP + FN), Precision = TP / (TP + FP), IoU = TP / (TP + FP + FN): by volume;
 *   - Leak = blocked light at samples outside the cones / all blocked light;
 *   - Lost = light that is not blocked at samples inside / all light that is not blocked;
 *   - LightPrecision = blocked light / all light, both at samples inside;
 *   - VolumeError = (TP + FP) / (TP + FN) - 1: the volume of the union of the cones over that of the shadow, - 1;
 *   - UmbraPrecision, UmbraRecall: samples in umbra (Truth = 0) and predicted to be, over those predicted, over those
 *     in umbra;
 *   - Certified: 1 where the independent check finds each part of the mesh, before each part of the light, in one cone with all
 *     its shadow, whatever the field data say; else 0. Then Leak is 0 as a fact, and not as far as the samples tell;
 *   - with CompareBounds: ClusterCones, ClusterPrecision, ClusterRecall: number, precision and recall of cones around parts of the
 *     mesh, made without photons; SweptBoxPrecision, SweptBoxRecall: those of each occluder's bounding box swept along the light;
 *   - ShadowClassRecall, ...Precision, ...IoU, ...UmbraPrecision, ...UmbraRecall: the same for "ShadowClass" of input
 *     port 0, where given.
 *
 * Intervals: of Wilson for counts. For light Wilson's too, for as many samples as give a proportion the standard error
 * of the ratio estimate. For VolumeError 1.96 standard errors of the ratio estimate. They say what a random sample
 * leaves open; stratified samples leave less, given samples that follow a pattern may leave anything.
 *
 * Output port 2, vtkTable, one row an occluder that has samples: "OccluderId" (int), "SampleCount" (id), and each of
 * Recall, Precision, IoU, Leak, Lost as three columns, as in "Recall", "RecallLow", "RecallHigh" (double). Lost is over
 * all light that is not blocked, of all samples: the rows add up to the summary.
 *
 * Output port 3, vtkTable, the same along Depth, one row a bin: "DepthMin", "DepthMax" (double) in place of
 * "OccluderId".
 *
 * Output port 4, the cone set with all its arrays and point data "SampleCount" (id, samples inside the cone),
 * "Precision", "PrecisionLow", "PrecisionHigh" (float, the share of them that is shadowed; NaN without samples), "Lost"
 * (float, as above for this cone alone). vtkConeSetGeometry passes them on, for colours.
 *
 * @warning Truth comes from a finite number of light points: a sample of which less than 1 / NumberOfLightSamples is
 * hidden may count as lit.
 * @sa vtkConeSetFilter vtkConeSetGeometry
 */
#ifndef vtkConeSetAccuracy_h
#define vtkConeSetAccuracy_h

#include "ShadowConesFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>

class SHADOWCONESFILTERS_EXPORT vtkConeSetAccuracy : public vtkPolyDataAlgorithm
{
public:
  static vtkConeSetAccuracy* New();
  vtkTypeMacro(vtkConeSetAccuracy, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /// Out of memory is a message, and leaves empty outputs.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /// The cone set, input port 1. Required.
  void SetConeSetConnection(vtkAlgorithmOutput* coneSet);
  void SetConeSetData(vtkDataObject* coneSet); ///< The cone set as a data object, without a pipeline.
  ///@}

  ///@{
  /// The mesh that casts the shadow, input port 2. Required.
  void SetMeshConnection(vtkAlgorithmOutput* mesh);
  void SetMeshData(vtkDataObject* mesh); ///< The mesh as a data object, without a pipeline.
  ///@}

  ///@{
  /// The light, input port 3. Required.
  /// Several lights: one a connection, or a block of a composite, all with the same wavelengths. Set replaces all of
  /// them.
  void SetLightConnection(vtkAlgorithmOutput* light);
  void SetLightData(vtkDataObject* light);            ///< The light as a data object, without a pipeline.
  void AddLightConnection(vtkAlgorithmOutput* light); ///< One more light.
  void AddLightData(vtkDataObject* light);            ///< One more light as a data object, without a pipeline.
  void RemoveAllLights();                             ///< No light is connected from here on.
  ///@}

  ///@{
  /// Samples to draw where input port 0 is not connected, 0 to 1e9; memory is about 100 bytes each. Default 50000.
  vtkSetMacro(NumberOfSamples, vtkIdType);
  vtkGetMacro(NumberOfSamples, vtkIdType); ///< Samples that are drawn where input port 0 is not connected.
  ///@}

  ///@{
  /// Points of the light to look at from each sample, 1 to 65536. Default 64.
  vtkSetMacro(NumberOfLightSamples, int);
  vtkGetMacro(NumberOfLightSamples, int); ///< Points of the light to look at from each sample.
  ///@}

  ///@{
  /// The box to draw samples in: x from, to, y from, to, z from, to, world units. Default (1, -1, 1, -1, 1, -1), which
  /// stands for the joint bounds of mesh and light (without a Sun). Valid: from at most to.
  vtkSetVector6Macro(Bounds, double);
  /// The box to draw samples in, world units: x from, to, y from, to, z from, to.
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /// Rows of the table along Depth, 1 to 100000, of one width from 0 to the largest depth. Default 16.
  vtkSetMacro(NumberOfDepthBins, int);
  vtkGetMacro(NumberOfDepthBins, int); ///< Rows of the table along Depth.
  ///@}

  ///@{
  /// Any integer: chooses the samples and the points of the light. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int); ///< Number that chooses the samples and the points of the light.
  ///@}

  ///@{
  /// Measure two other bounds of the shadow beside the cones: cones around parts of the mesh without photons, and each occluder's
  /// bounding box swept along the light. Default off.
  vtkSetMacro(CompareBounds, bool);
  vtkGetMacro(CompareBounds, bool); ///< Whether two other bounds are measured too.
  /// Measure two other bounds too.
  vtkBooleanMacro(CompareBounds, bool); ///< Measure the cone set alone.
  ///@}

protected:
  vtkConeSetAccuracy();
  ~vtkConeSetAccuracy() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConeSetAccuracy(const vtkConeSetAccuracy&) = delete;
  void operator=(const vtkConeSetAccuracy&) = delete;

  struct Inputs;
  struct Outcome;

  /// What is wrong with the parameters, as a sentence; empty where nothing is.
  std::string CheckParameters() const;
  bool ReadInputs(vtkInformationVector** inputVector, Inputs& in, std::string& error) const;
  /// @return false where aborted.
  bool Measure(Inputs& in, Outcome& out);

  vtkIdType NumberOfSamples = 50000;
  int NumberOfLightSamples = 64;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  int NumberOfDepthBins = 16;
  bool CompareBounds = false;
  int Seed = 1;
};

#endif
