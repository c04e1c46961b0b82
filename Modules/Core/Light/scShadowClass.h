// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scShadowClass.h
 * @brief What a point sees of a light: its shadow class, and the visible fraction from samples.
 */
#ifndef scShadowClass_h
#define scShadowClass_h

namespace shadowcones
{

/// Values of "ShadowClass".
enum class ShadowClass : unsigned char
{
  Lit = 0,
  Penumbra = 1,
  Umbra = 2
};

/// Is this one of them, as a number of an array of any type?
inline bool IsShadowClass(double value)
{
  return value == 0.0 || value == 1.0 || value == 2.0;
}

/// Samples of a light that emit towards a point, and how many of these are seen: the one rule for fraction and class.
struct SeenSamples
{
  int Emitting = 0;
  int Visible = 0;

  /// Visible fraction of the light; 1 where none emits.
  double Fraction() const
  {
    return this->Emitting > 0 ? static_cast<double>(this->Visible) / static_cast<double>(this->Emitting) : 1.0;
  }
  ShadowClass Class() const
  {
    return this->Visible == this->Emitting ? ShadowClass::Lit
                                           : (this->Visible == 0 ? ShadowClass::Umbra : ShadowClass::Penumbra);
  }
};

} // namespace shadowcones

#endif
