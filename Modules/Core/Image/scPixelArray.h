// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPixelArray.h
 * @brief Values of pixels, whose memory nobody touches before it is written.
 */
#ifndef scPixelArray_h
#define scPixelArray_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace shadowcones
{

/// Where a vector would set all values on one thread, the gigabytes of a large image are set by those who fill them. Its
/// memory can be handed on, to be freed by std::free.
template <typename T>
class PixelArray
{
  static_assert(std::is_trivially_copyable<T>::value); // values are set without being made

public:
  using value_type = T;
  using iterator = T*;
  using const_iterator = const T*;

  PixelArray() = default;
  ~PixelArray() = default;
  PixelArray(const PixelArray& other)
  {
    this->Resize(other.Count);
    std::copy(other.begin(), other.end(), this->begin());
  }
  PixelArray(PixelArray&& other) noexcept
    : Values(std::move(other.Values))
    , Count(std::exchange(other.Count, 0))
  {
  }
  PixelArray& operator=(PixelArray other) noexcept
  {
    std::swap(this->Values, other.Values);
    std::swap(this->Count, other.Count);
    return *this;
  }

  /// What was there is gone, and what is there has no value yet.
  void Resize(std::size_t count)
  {
    if (count != this->Count)
    {
      this->Count = 0;
      this->Values.reset();
      if (count > PTRDIFF_MAX / sizeof(T))
      {
        throw std::bad_alloc();
      }
      this->Values.reset(count > 0 ? static_cast<T*>(std::malloc(count * sizeof(T))) : nullptr);
      if (count > 0 && !this->Values)
      {
        throw std::bad_alloc();
      }
      this->Count = count;
    }
  }
  /// Hand the memory on: nothing is left.
  T* Release()
  {
    this->Count = 0;
    return this->Values.release();
  }

  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  T* data() { return this->Values.get(); }
  const T* data() const { return this->Values.get(); }
  T* begin() { return this->data(); }
  T* end() { return this->data() + this->Count; }
  const T* begin() const { return this->data(); }
  const T* end() const { return this->data() + this->Count; }
  T& operator[](std::size_t i) { return this->data()[i]; }
  const T& operator[](std::size_t i) const { return this->data()[i]; }
  T& front() { return *this->begin(); }
  const T& front() const { return *this->begin(); }

  bool operator==(const PixelArray& other) const
  {
    return std::equal(this->begin(), this->end(), other.begin(), other.end());
  }
  bool operator==(const std::vector<T>& other) const
  {
    return std::equal(this->begin(), this->end(), other.begin(), other.end());
  }
  bool operator!=(const PixelArray& other) const { return !(*this == other); }
  /// A copy, for what takes a vector.
  operator std::vector<T>() const { return { this->begin(), this->end() }; }

private:
  struct Free
  {
    void operator()(T* values) const { std::free(values); }
  };
  std::unique_ptr<T[], Free> Values;
  std::size_t Count = 0;
};

} // namespace shadowcones

#endif
