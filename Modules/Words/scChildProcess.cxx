// SPDX-License-Identifier: BSD-3-Clause
#include "scChildProcess.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace shadowcones
{

namespace
{

// Bytes of address space that this process has; 0 where the system does not say.
std::int64_t AddressSpace()
{
  std::int64_t pages = 0;
  const std::string self = "/proc/self";
  std::ifstream(self + "/statm") >> pages;
  return pages * sysconf(_SC_PAGESIZE);
}

void LimitMemory(std::int64_t more)
{
  const std::int64_t now = AddressSpace();
  // Programs that watch their memory (sanitizers) set terabytes aside: no limit can be told from those.
  if (more <= 0 || now <= 0 || now > (std::int64_t(1) << 42))
  {
    return;
  }
  const auto limit = static_cast<rlim_t>(now + more);
  const rlimit both{ limit, limit };
  setrlimit(RLIMIT_AS, &both);
}

bool WriteAll(int file, const char* bytes, std::size_t count)
{
  while (count > 0)
  {
    const ssize_t written = write(file, bytes, count);
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      return false;
    }
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

[[noreturn]] void BeChild(const std::function<std::string()>& work, const ChildLimits& limits, int file)
{
  for (const int number : { SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGPIPE })
  {
    std::signal(number, SIG_DFL);
  }
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : { 0, 1, 2 })
  {
    dup2(nowhere, stream);
  }
  // The threads of this process were not copied: nobody else would take a share of the work.
  vtkSMPTools::SetBackend("Sequential");
  LimitMemory(limits.Memory);
  try
  {
    const std::string answer = work();
    const auto size = static_cast<std::uint64_t>(answer.size());
    const bool told = WriteAll(file, reinterpret_cast<const char*>(&size), sizeof(size)) &&
      WriteAll(file, answer.data(), answer.size());
    _exit(told ? 0 : 1);
  }
  catch (const std::exception&)
  {
    _exit(1);
  }
}

// All that comes before the other end is closed. @return false where the time is over first.
bool ReadAll(int file, double seconds, std::string& bytes)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  char part[1 << 16];
  for (;;)
  {
    const double left = std::chrono::duration<double>(end - std::chrono::steady_clock::now()).count();
    if (left <= 0.0)
    {
      return false;
    }
    pollfd wait{ file, POLLIN, 0 };
    const int ready = poll(&wait, 1, static_cast<int>(std::min(left * 1000.0 + 1.0, 1e6)));
    if (ready < 0 && errno != EINTR)
    {
      return true;
    }
    if (ready <= 0)
    {
      continue;
    }
    const ssize_t count = read(file, part, sizeof(part));
    if (count > 0)
    {
      bytes.append(part, static_cast<std::size_t>(count));
    }
    else if (count == 0 || errno != EINTR)
    {
      return true;
    }
  }
}

} // namespace

ChildEnd RunInChild(const std::function<std::string()>& work, const ChildLimits& limits, std::string& answer)
{
  answer.clear();
  int ends[2];
  if (pipe(ends) != 0)
  {
    return ChildEnd::NotBegun;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    BeChild(work, limits, ends[1]);
  }
  close(ends[1]);
  if (child < 0)
  {
    close(ends[0]);
    return ChildEnd::NotBegun;
  }
  std::string bytes;
  const bool inTime = ReadAll(ends[0], limits.Seconds, bytes);
  close(ends[0]);
  if (!inTime)
  {
    kill(child, SIGKILL);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  if (!inTime)
  {
    return ChildEnd::TimedOut;
  }
  // Whole or not at all: its length comes first.
  std::uint64_t size = 0;
  if (bytes.size() < sizeof(size))
  {
    return ChildEnd::Crashed;
  }
  std::memcpy(&size, bytes.data(), sizeof(size));
  if (bytes.size() - sizeof(size) != size)
  {
    return ChildEnd::Crashed;
  }
  answer = bytes.substr(sizeof(size));
  return ChildEnd::Answered;
}

} // namespace shadowcones
