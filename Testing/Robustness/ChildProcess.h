// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildProcess.h
 * @brief Work that may crash or not end, in a process of its own that tells of it line by line.
 */
#ifndef ChildProcess_h
#define ChildProcess_h

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace robustness
{

/// Fields of a line.
using Line = std::vector<std::string>;
using Tell = std::function<void(const Line&)>;

struct ChildEnd
{
  std::vector<Line> Lines;
  int Status = 0;

  bool Crashed() const { return this->Status != 0; }
  std::string Why() const
  {
    return WIFSIGNALED(this->Status) && WTERMSIG(this->Status) == SIGALRM
      ? "no end"
      : "a crash, status " + std::to_string(this->Status);
  }
};

/// What @p work tells is here even where it then crashes. Nothing may have started threads in this process before.
inline ChildEnd RunInChild(const std::function<void(const Tell&)>& work)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    std::perror("pipe");
    std::exit(2);
  }
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    work(
      [&](const Line& line)
      {
        std::string text;
        for (const std::string& field : line)
        {
          text += (text.empty() ? "" : "\t") + field.substr(0, 600);
        }
        std::replace(text.begin(), text.end(), '\n', ' ');
        text += '\n';
        if (write(ends[1], text.data(), text.size()) < 0)
        {
          _exit(3);
        }
      });
    _exit(0);
  }
  close(ends[1]);
  std::string all;
  char part[4096];
  for (ssize_t count = 0; (count = read(ends[0], part, sizeof(part))) > 0;)
  {
    all.append(part, static_cast<std::size_t>(count));
  }
  close(ends[0]);
  ChildEnd end;
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);)
  {
    end.Lines.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, '\t');)
    {
      end.Lines.back().push_back(field);
    }
  }
  waitpid(child, &end.Status, 0);
  return end;
}

/// This process gets so many more bytes of addresses than it has; below 0: as many as it may have.
inline void LimitAddresses(std::int64_t more = -1)
{
  rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = limit.rlim_max;
  if (more >= 0)
  {
    std::ifstream file("/proc/self/statm");
    std::int64_t pages = 0;
    file >> pages;
    limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE) + more));
  }
  setrlimit(RLIMIT_AS, &limit);
}

} // namespace robustness

#endif
