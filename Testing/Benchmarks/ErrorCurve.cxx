// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCurve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shadowcones
{
namespace
{
constexpr double smallest = 1e-9;
} // namespace

//------------------------------------------------------------------------------
TimeAtError TimeAt(std::vector<CurvePoint> points, double error)
{
  std::sort(points.begin(), points.end(),
    [](const CurvePoint& a, const CurvePoint& b)
    { return a.Seconds != b.Seconds ? a.Seconds < b.Seconds : a.Error < b.Error; });
  const CurvePoint* before = nullptr;
  for (const CurvePoint& point : points)
  {
    if (before && point.Error >= before->Error)
    {
      continue;
    }
    if (point.Error <= error)
    {
      if (!before)
      {
        return { TimeAtError::AtMost, point.Seconds };
      }
      const double high = std::log(before->Error);
      const double low = std::log(std::max(point.Error, smallest));
      const double share = (high - std::log(std::max(error, smallest))) / (high - low);
      const double from = std::log(std::max(before->Seconds, smallest));
      const double to = std::log(std::max(point.Seconds, smallest));
      return { TimeAtError::Interpolated, std::exp(from + share * (to - from)) };
    }
    before = &point;
  }
  return {};
}

//------------------------------------------------------------------------------
double GrowthExponent(const std::vector<double>& x, const std::vector<double>& y)
{
  const auto count = static_cast<double>(x.size());
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    meanX += std::log(x[k]) / count;
    meanY += std::log(y[k]) / count;
  }
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    const double dx = std::log(x[k]) - meanX;
    products += dx * (std::log(y[k]) - meanY);
    squares += dx * dx;
  }
  return squares > 0.0 ? products / squares : 0.0;
}

//------------------------------------------------------------------------------
double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

} // namespace shadowcones
