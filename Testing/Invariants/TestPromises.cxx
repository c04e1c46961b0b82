// SPDX-License-Identifier: BSD-3-Clause
// What every filter promises: the same bytes for any threads and pieces, progress, abort, inputs left alone.
#include "Cases.h"
#include "DataBytes.h"
#include "LoopBackends.h"
#include "Messages.h"
#include "TimeLimit.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>

using namespace invariants;
using namespace shadowcones::testsupport;

namespace
{

class Promises : public testing::TestWithParam<Case>
{
};

Setting Connected(const Case& one, Size size = Size::Small)
{
  Setting setting = one.Make(size);
  setting.Connect();
  return setting;
}

/// What a consumer of one output port asks for.
void UpdatePort(vtkAlgorithm* filter, int port, int piece, int pieces)
{
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(filter->GetNumberOfOutputPorts());
  vtkInformation* request = requests->GetInformationObject(port);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), piece);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  filter->Update(port, requests);
}

} // namespace

TEST_P(Promises, ThreadsDoNotChangeABit)
{
  const std::string before = vtkSMPTools::GetBackend();
  NamedBytes reference;
  for (const auto& [backend, threads] :
    { std::make_pair("Sequential", 1), std::make_pair("STDThread", 1), std::make_pair("STDThread", 2),
      std::make_pair("STDThread", 5), std::make_pair("TBB", 1), std::make_pair("TBB", 2) })
  {
    if (!UseLoopBackend(backend))
    {
      continue;
    }
    vtkSMPTools::Initialize(threads);
    const Setting setting = Connected(GetParam());
    Messages messages(setting.Filter);
    setting.Filter->Update();
    EXPECT_EQ(messages.Errors, "");
    EXPECT_FALSE(IsEmpty(setting.Filter->GetOutputDataObject(0)));
    const NamedBytes bytes = BytesOfOutputs(setting.Filter);
    reference = reference.empty() ? bytes : reference;
    EXPECT_EQ(Difference(reference, bytes), "") << backend << " " << threads;
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(before.c_str());
  ASSERT_FALSE(reference.empty());
}

TEST_P(Promises, PiecesJoinToTheWhole)
{
  const Setting whole = Connected(GetParam());
  whole.Filter->Update();
  const Setting parts = Connected(GetParam());
  for (int port = 0; port < whole.Filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = whole.Filter->GetOutputDataObject(port);
    if (!vtkDataSet::SafeDownCast(output) || vtkImageData::SafeDownCast(output))
    {
      continue; // tables are whole in piece 0; images: see ExtentsJoinToTheWhole
    }
    const NamedBytes truth = CellSoup(output);
    for (const int pieces : { 4, 3 })
    {
      NamedBytes joined;
      for (int piece = 0; piece < pieces; ++piece)
      {
        UpdatePort(parts.Filter, port, piece, pieces);
        const NamedBytes part = CellSoup(parts.Filter->GetOutputDataObject(port));
        if (!GetParam().Divides)
        {
          EXPECT_EQ(Difference(truth, part), "");
          joined = part;
          continue;
        }
        EXPECT_LT(part.empty() ? 0 : part.at("sizes").size(), truth.at("sizes").size());
        for (const auto& [name, bytes] : part)
        {
          joined[name] += bytes;
        }
      }
      EXPECT_EQ(Difference(truth, joined), "") << "port " << port << ", " << pieces << " pieces";
    }
  }
}

TEST_P(Promises, OnePortInPiecesLeavesTheOthersWhole)
{
  const Setting whole = Connected(GetParam());
  whole.Filter->Update();
  const NamedBytes truth = BytesOfOutputs(whole.Filter);
  const Setting setting = Connected(GetParam());
  if (vtkImageData::SafeDownCast(whole.Filter->GetOutputDataObject(0)))
  {
    GTEST_SKIP() << "one image has no other ports";
  }
  // Two consumers: one asks port 0 for a piece, then another asks the last port for all.
  setting.Filter->Update();
  UpdatePort(setting.Filter, 0, 2, 4);
  const int last = setting.Filter->GetNumberOfOutputPorts() - 1;
  UpdatePort(setting.Filter, last, 0, 1);
  EXPECT_EQ(
    Difference(BytesOf(whole.Filter->GetOutputDataObject(last)), BytesOf(setting.Filter->GetOutputDataObject(last))),
    "");
}

TEST_P(Promises, ExtentsJoinToTheWhole)
{
  const Setting whole = Connected(GetParam());
  whole.Filter->Update();
  auto* image = vtkImageData::SafeDownCast(whole.Filter->GetOutputDataObject(0));
  if (!image)
  {
    GTEST_SKIP() << "not an image";
  }
  const NamedBytes truth = CellSoup(image);
  int extent[6];
  image->GetExtent(extent);
  // Four uneven parts, joined row by row.
  const int middleX = extent[1] / 3;
  const int middleY = extent[3] / 2 + 2;
  const Setting parts = Connected(GetParam());
  std::map<std::pair<int, int>, vtkSmartPointer<vtkImageData>> images;
  for (const bool right : { false, true })
  {
    for (const bool upper : { false, true })
    {
      const int part[6] = { right ? middleX + 1 : 0, right ? extent[1] : middleX, upper ? middleY + 1 : 0,
        upper ? extent[3] : middleY, extent[4], extent[5] };
      parts.Filter->UpdateExtent(part);
      auto copy = vtkSmartPointer<vtkImageData>::New();
      copy->DeepCopy(parts.Filter->GetOutputDataObject(0));
      ASSERT_TRUE(std::equal(part, part + 6, copy->GetExtent()));
      images[{ right, upper }] = copy;
    }
  }
  for (int array = 0; array < image->GetPointData()->GetNumberOfArrays(); ++array)
  {
    vtkDataArray* expected = image->GetPointData()->GetArray(array);
    int different = 0;
    for (int z = extent[4]; z <= extent[5]; ++z)
    {
      for (int y = extent[2]; y <= extent[3]; ++y)
      {
        for (int x = extent[0]; x <= extent[1]; ++x)
        {
          int p[3] = { x, y, z };
          vtkImageData* part = images[{ x > middleX, y > middleY }];
          vtkDataArray* found = part->GetPointData()->GetArray(expected->GetName());
          ASSERT_NE(found, nullptr) << expected->GetName();
          for (int c = 0; c < expected->GetNumberOfComponents(); ++c)
          {
            different +=
              expected->GetComponent(image->ComputePointId(p), c) != found->GetComponent(part->ComputePointId(p), c);
          }
        }
      }
    }
    EXPECT_EQ(different, 0) << expected->GetName();
  }
}

TEST_P(Promises, ProgressGrowsToOne)
{
  const Setting setting = Connected(GetParam());
  std::vector<double> seen;
  OnProgress observer(setting.Filter, [&](vtkAlgorithm* filter) { seen.push_back(filter->GetProgress()); });
  setting.Filter->Update();
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << testing::PrintToString(seen);
  EXPECT_EQ(seen.back(), 1.0);
  if (GetParam().Long)
  {
    EXPECT_GE(std::set<double>(seen.begin(), seen.end()).size(), 4u) << testing::PrintToString(seen);
  }
}

TEST_P(Promises, AbortStopsSoonAndLeavesNothing)
{
  if (!GetParam().Long)
  {
    GTEST_SKIP() << "over before it could be stopped";
  }
  using Clock = std::chrono::steady_clock;
  const Setting setting = Connected(GetParam(), Size::Large);
  Messages messages(setting.Filter);
  Clock::time_point stopped;
  double progress = -1.0;
  OnProgress observer(setting.Filter,
    [&](vtkAlgorithm* filter)
    {
      if (filter->GetProgress() > 0.0 && progress < 0.0)
      {
        progress = filter->GetProgress();
        stopped = Clock::now();
        filter->SetAbortExecute(1);
      }
    });
  setting.Filter->Update();
  const double seconds = std::chrono::duration<double>(Clock::now() - stopped).count();
  EXPECT_GT(progress, 0.0);
  EXPECT_LT(progress, 0.7); // there was something left to stop
  EXPECT_LT(seconds, TimeLimit(0.5));
  RecordProperty("secondsToStop", std::to_string(seconds));
  for (int port = 0; port < setting.Filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(IsEmpty(setting.Filter->GetOutputDataObject(port))) << "port " << port;
  }
  EXPECT_EQ(messages.Errors, "");
}

TEST_P(Promises, AnAbortLeavesNothingOfTheRunBeforeAndTheNextIsComplete)
{
  if (!GetParam().Long)
  {
    GTEST_SKIP() << "over before it could be stopped";
  }
  const Setting setting = Connected(GetParam());
  setting.Filter->Update();
  const NamedBytes whole = BytesOfOutputs(setting.Filter);
  bool stopped = false;
  {
    OnProgress observer(setting.Filter,
      [&stopped](vtkAlgorithm* filter)
      {
        if (filter->GetProgress() > 0.0 && filter->GetProgress() < 1.0)
        {
          stopped = true;
          filter->SetAbortExecute(1);
        }
      });
    setting.Filter->Modified();
    setting.Filter->Update();
  }
  EXPECT_TRUE(stopped);
  for (int port = 0; port < setting.Filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(IsEmpty(setting.Filter->GetOutputDataObject(port))) << "port " << port;
  }
  setting.Filter->SetAbortExecute(0); // VTK 9.3 leaves the flag to its user
  setting.Filter->Modified();
  setting.Filter->Update();
  EXPECT_EQ(Difference(whole, BytesOfOutputs(setting.Filter)), "");
}

TEST_P(Promises, InputsAreLeftAlone)
{
  Setting setting = GetParam().Make(Size::Small);
  // Copies of its own, so that nobody else has touched them.
  std::vector<NamedBytes> bytes;
  std::vector<std::map<std::string, vtkMTimeType>> times;
  for (auto& [port, data] : setting.Inputs)
  {
    vtkSmartPointer<vtkDataObject> copy = vtk::TakeSmartPointer(data->NewInstance());
    copy->DeepCopy(data);
    data = copy;
    bytes.push_back(BytesOf(data));
    times.push_back(TimesOf(data));
  }
  setting.Connect();
  setting.Filter->Update();
  setting.Filter->UpdatePiece(1, 3, 0);
  for (std::size_t i = 0; i < setting.Inputs.size(); ++i)
  {
    vtkDataObject* data = setting.Inputs[i].second;
    EXPECT_EQ(Difference(bytes[i], BytesOf(data)), "") << "input port " << setting.Inputs[i].first;
    EXPECT_EQ(times[i], TimesOf(data)) << "input port " << setting.Inputs[i].first;
  }
}

TEST_P(Promises, ASecondUpdateDoesNothing)
{
  const Setting setting = Connected(GetParam());
  setting.Filter->Update();
  const vtkMTimeType time = setting.Filter->GetOutputDataObject(0)->GetMTime();
  setting.Filter->Update();
  EXPECT_EQ(setting.Filter->GetOutputDataObject(0)->GetMTime(), time);
}

INSTANTIATE_TEST_SUITE_P(Every, Promises, testing::ValuesIn(AllCases()),
  [](const testing::TestParamInfo<Case>& info) { return info.param.Name; });
