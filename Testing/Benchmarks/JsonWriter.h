// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JsonWriter.h
 * @brief Nested objects and lists of numbers and short texts, written as JSON.
 */
#ifndef JsonWriter_h
#define JsonWriter_h

#include <cmath>
#include <iomanip>
#include <ostream>
#include <string>
#include <type_traits>

namespace shadowcones
{

/// Keys are given inside objects and are empty inside lists.
class JsonWriter
{
public:
  explicit JsonWriter(std::ostream& out)
    : Out(out)
  {
    this->Out << std::setprecision(9);
  }

  void BeginObject(const std::string& key = "") { this->Begin(key, '{'); }
  void EndObject() { this->End('}'); }
  void BeginList(const std::string& key = "") { this->Begin(key, '['); }
  void EndList() { this->End(']'); }

  void Write(const std::string& key, const std::string& value)
  {
    this->Next(key);
    this->Quote(value);
  }
  void Write(const std::string& key, const char* value) { this->Write(key, std::string(value)); }
  /// Numbers that are not finite become null.
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  void Write(const std::string& key, Number value)
  {
    this->Next(key);
    if constexpr (std::is_same_v<Number, bool>)
    {
      this->Out << (value ? "true" : "false");
    }
    else if (std::isfinite(static_cast<double>(value)))
    {
      this->Out << value;
    }
    else
    {
      this->Out << "null";
    }
  }

private:
  void Begin(const std::string& key, char bracket)
  {
    this->Next(key);
    this->Out << bracket;
    this->Indent += 2;
    this->First = true;
  }
  void End(char bracket)
  {
    this->Indent -= 2;
    this->NewLine();
    this->Out << bracket;
    this->First = false;
  }
  void Next(const std::string& key)
  {
    this->Out << (this->First ? "" : ",");
    if (this->Indent > 0)
    {
      this->NewLine();
    }
    this->First = false;
    if (!key.empty())
    {
      this->Quote(key);
      this->Out << ": ";
    }
  }
  void NewLine() { this->Out << '\n' << std::string(static_cast<std::size_t>(this->Indent), ' '); }
  void Quote(const std::string& text)
  {
    this->Out << '"';
    for (const char c : text)
    {
      if (c == '"' || c == '\\')
      {
        this->Out << '\\';
      }
      this->Out << (static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
    }
    this->Out << '"';
  }

  std::ostream& Out;
  int Indent = 0;
  bool First = true;
};

} // namespace shadowcones

#endif
