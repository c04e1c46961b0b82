// SPDX-License-Identifier: BSD-3-Clause
// Every input of the corpus once more, and bytes at random after them: no clang needed.
//   fuzz-replay CORPUS [RUNS [HARNESS]...]  all harnesses or those named, each with its text of CORPUS
//   fuzz-replay --one HARNESS FILE          one input
#include "Harnesses.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace
{

using Input = std::vector<std::uint8_t>;

Input Read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// The inputs of a text: a line each, its name and then its bytes in hexadecimal digits.
std::vector<Input> ReadCorpus(const std::string& path)
{
  std::vector<Input> corpus;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t blank = line.find(' ');
    if (line.empty() || line[0] == '#' || blank == std::string::npos)
    {
      continue;
    }
    corpus.emplace_back();
    for (std::size_t k = blank + 1; k + 1 < line.size(); k += 2)
    {
      corpus.back().push_back(static_cast<std::uint8_t>(std::stoi(line.substr(k, 2), nullptr, 16)));
    }
  }
  return corpus;
}

// What is being tried: written to a file where it breaks something.
const Input* tried = nullptr;

void KeepInput(int number)
{
  const int file = tried ? open("fuzz-replay-broken", O_CREAT | O_TRUNC | O_WRONLY, 0644) : -1;
  if (file >= 0 && write(file, tried->data(), tried->size()) >= 0)
  {
    close(file);
  }
  std::signal(number, SIG_DFL);
  std::raise(number);
}

/// Bytes at random, and inputs of the corpus with some of their bytes changed.
Input MakeInput(std::mt19937_64& random, const std::vector<Input>& corpus)
{
  Input input;
  if (!corpus.empty() && random() % 2 == 0)
  {
    input = corpus[random() % corpus.size()];
    for (std::uint64_t k = 1 + random() % 4; k > 0 && !input.empty(); --k)
    {
      input[random() % input.size()] = static_cast<std::uint8_t>(random());
    }
    return input;
  }
  input.resize(random() % 400);
  for (std::uint8_t& byte : input)
  {
    byte = static_cast<std::uint8_t>(random());
  }
  return input;
}

void Replay(const fuzz::Harness& harness, const std::string& folder, int runs)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Input> corpus = ReadCorpus(folder + "/" + harness.Name + ".txt");
  fuzz::GoesAllTheWay() = true;
  for (std::size_t k = 0; k < corpus.size(); ++k)
  {
    std::fprintf(stderr, "%s, input %zu\n", harness.Name, k);
    alarm(60);
    harness.Run(corpus[k].data(), corpus[k].size());
  }
  fuzz::GoesAllTheWay() = false;
  std::mt19937_64 random(1);
  for (int run = 0; run < runs; ++run)
  {
    alarm(60);
    const Input input = MakeInput(random, corpus);
    tried = &input;
    harness.Run(input.data(), input.size());
    tried = nullptr;
  }
  alarm(0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf("%-12s %5zu inputs, %7d at random, %8.0f executions a second, lost: 0\n", harness.Name, corpus.size(), runs,
    (static_cast<double>(corpus.size()) + runs) / seconds);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  vtkSMPTools::SetBackend("Sequential");
  for (const int number : { SIGSEGV, SIGABRT, SIGFPE, SIGALRM })
  {
    std::signal(number, KeepInput);
  }
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool one = words.size() == 3 && words[0] == "--one";
  int run = 0;
  for (const fuzz::Harness& harness : fuzz::Harnesses())
  {
    const auto names = words.size() > 2 ? words.begin() + (one ? 1 : 2) : words.end();
    const bool named = std::find(names, words.end(), harness.Name) != words.end();
    if (one && words[1] == harness.Name)
    {
      const Input input = Read(words[2]);
      fuzz::GoesAllTheWay() = true;
      harness.Run(input.data(), input.size());
      ++run;
    }
    else if (!one && !words.empty() && (named || words.size() < 3))
    {
      Replay(harness, words[0], words.size() > 1 ? std::atoi(words[1].c_str()) : 0);
      ++run;
    }
  }
  if (run == 0)
  {
    std::fprintf(stderr, "fuzz-replay CORPUS [RUNS [HARNESS]...], or fuzz-replay --one HARNESS FILE\n");
    return 2;
  }
  return 0;
}
