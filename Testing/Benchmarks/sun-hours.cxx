// SPDX-License-Identifier: BSD-3-Clause
// What hours in the Sun cost: a town of boxes, sensors between and above them, a day and a year, a hard Sun and its
// disc.
//
// Seconds are of vtkSunHours as a whole, with its search tree; the path is made before. Every row is the least of
// several runs.
#include "ProgramOptions.h"
#include "TestMeshes.h"
#include "TestPolyData.h"
#include "scRandom.h"
#include "vtkSunHours.h"
#include "vtkSunPath.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

using namespace shadowcones;
using namespace testsupport;

namespace
{

constexpr double street = 20.0; // from house to house

/// Houses of 12 triangles on a square, each of a height of its own.
vtkSmartPointer<vtkPolyData> Town(int triangles, double& size)
{
  const int side = static_cast<int>(std::ceil(std::sqrt(triangles / 12.0)));
  size = side * street;
  TestMesh town;
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      RandomStream random(1, static_cast<std::uint64_t>(i * side + j));
      const Vector3 corner{ i * street, j * street, 0.0 };
      town.AddBox(corner, corner + Vector3{ 12.0, 12.0, 5.0 + 35.0 * random.Next() });
    }
  }
  return ToPolyData(town);
}

vtkSmartPointer<vtkPolyData> Sensors(int count, double size)
{
  std::vector<double> points;
  for (int k = 0; k < count; ++k)
  {
    RandomStream random(2, static_cast<std::uint64_t>(k));
    points.insert(points.end(), { size * random.Next(), size * random.Next(), 45.0 * random.Next() });
  }
  return PointsAt(points);
}

struct Job
{
  const char* Name;
  const char* Start;
  const char* End;
  double Step;     // minutes
  double Diameter; // degrees
};

double Seconds(vtkSunHours* filter, int runs)
{
  using Clock = std::chrono::steady_clock;
  double least = 1e300;
  for (int run = 0; run < runs; ++run)
  {
    filter->Modified();
    const auto start = Clock::now();
    filter->Update();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least;
}

} // namespace

int main(int argc, char** argv)
{
  ProgramOptions commandLine("Time of vtkSunHours in a town of boxes, at 48 degrees north");
  int triangles = 100000;
  int sensors = 10000;
  int runs = 3;
  bool year = false;
  commandLine.AddPositive("--triangles", triangles, "triangles of the town, at least");
  commandLine.AddPositive("--sensors", sensors, "places that are asked");
  commandLine.AddPositive("--runs", runs, "runs, of which the quickest counts");
  commandLine.AddFlag("--year", year, "a year in steps of ten minutes too");
  if (const std::optional<int> status = commandLine.Read(argc, argv))
  {
    return *status;
  }

  double size = 0.0;
  const auto town = Town(triangles, size);
  const auto places = Sensors(sensors, size);
  std::printf("%lld triangles, %d sensors\n", static_cast<long long>(town->GetNumberOfCells()), sensors);
  std::printf("%-28s %8s %10s %12s %10s\n", "", "steps", "seconds", "ns a ray", "mean hours");
  std::vector<Job> jobs = { { "hard Sun, a day in June", "2024-06-21", "2024-06-22", 10.0, 0.0 },
    { "hard Sun, a day in December", "2024-12-21", "2024-12-22", 10.0, 0.0 },
    { "disc, a day in June", "2024-06-21", "2024-06-22", 10.0, 0.533 },
    { "hard Sun, a day, 1 minute", "2024-06-21", "2024-06-22", 1.0, 0.0 } };
  if (year)
  {
    jobs.push_back({ "hard Sun, a year", "2024-01-01", "2025-01-01", 10.0, 0.0 });
  }
  for (const Job& job : jobs)
  {
    vtkNew<vtkSunPath> path;
    path->SetLatitude(48.0);
    path->SetLongitude(11.0);
    path->SetStart(job.Start);
    path->SetEnd(job.End);
    path->SetStep(job.Step);
    path->SetAngularDiameter(job.Diameter);
    path->Update();
    vtkNew<vtkSunHours> filter;
    filter->SetInputData(places);
    filter->SetMeshData(town);
    filter->SetPathData(path->GetOutput());
    const double seconds = Seconds(filter, runs);
    vtkDataArray* altitudes = path->GetOutput()->GetFieldData()->GetArray("SunStepAltitude");
    double rays = 0.0;
    for (vtkIdType k = 0; k < altitudes->GetNumberOfTuples(); ++k)
    {
      rays += altitudes->GetComponent(k, 0) > 0.0 ? (job.Diameter > 0.0 ? 64.0 : 1.0) * sensors : 0.0;
    }
    vtkDataArray* hours =
      vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetArray("SunHours");
    double sum = 0.0;
    for (vtkIdType k = 0; k < hours->GetNumberOfTuples(); ++k)
    {
      sum += hours->GetComponent(k, 0);
    }
    std::printf("%-28s %8lld %10.3f %12.1f %10.2f\n", job.Name, static_cast<long long>(altitudes->GetNumberOfTuples()),
      seconds, 1e9 * seconds / rays, sum / sensors);
    std::fflush(stdout);
  }
  return 0;
}
