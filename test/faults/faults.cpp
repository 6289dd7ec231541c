// SPDX-License-Identifier: GPL-3.0-or-later
// A library that is loaded before a program and makes one of its calls fail, once main() has begun:
//
//   FAULT=CALL:N[:MODE]   CALL is new, fopen, fwrite, fclose, rename, mkdir or remove; the call number N fails, counted
//                         from 1, and with the MODE "on" all after it, too; with "kill" the process is killed instead
//   FAULT_LOG=FILE        how many calls there were is written to the file when the process ends: a line for each CALL
//
// fwrite and fclose fail as on a full disk, the others as if permission was denied.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

enum Call
{
  NEW,
  FOPEN,
  FWRITE,
  FCLOSE,
  RENAME,
  MKDIR,
  REMOVE,
  NUMBER_OF_CALLS
};

const std::array<const char*, NUMBER_OF_CALLS> names = {
    {"new", "fopen", "fwrite", "fclose", "rename", "mkdir", "remove"}};

std::atomic<bool> is_armed(false);
std::array<std::atomic<long>, NUMBER_OF_CALLS> counts;
int faulty_call = -1;
long faulty_number = 0;
bool is_killed = false, goes_on = false;
int (*main_of_program)(int, char**, char**) = nullptr;

template <class Function>
Function next_function(const char* name)
{
  Function result;
  void* const symbol = dlsym(RTLD_NEXT, name);
  static_assert(sizeof result == sizeof symbol);
  std::memcpy(&result, &symbol, sizeof result);
  return result;
}

// Whether this call is to fail.
bool fails(Call call)
{
  if(!is_armed)
    return false;
  const long number = ++counts[call];
  if(call != faulty_call || (goes_on ? number < faulty_number : number != faulty_number))
    return false;
  if(is_killed)
    raise(SIGKILL);
  return true;
}

void read_environment()
{
  const char* const fault = std::getenv("FAULT");
  if(fault == nullptr)
    return;
  for(int call = 0; call < NUMBER_OF_CALLS; ++call)
  {
    const std::size_t length = std::strlen(names[static_cast<std::size_t>(call)]);
    if(std::strncmp(fault, names[static_cast<std::size_t>(call)], length) != 0 || fault[length] != ':')
      continue;
    char* mode = nullptr;
    faulty_call = call;
    faulty_number = std::strtol(fault + length + 1, &mode, 10);
    is_killed = std::strcmp(mode, ":kill") == 0;
    goes_on = std::strcmp(mode, ":on") == 0;
  }
}

int armed_main(int argc, char** argv, char** environment)
{
  read_environment();
  is_armed = true;
  const int result = main_of_program(argc, argv, environment);
  is_armed = false;
  if(const char* const log = std::getenv("FAULT_LOG"))
  {
    const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    for(std::size_t call = 0; call < NUMBER_OF_CALLS; ++call)
      dprintf(file, "%s %ld\n", names[call], counts[call].load());
    close(file);
  }
  return result;
}

} // namespace

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*end)(), void* stack)
{
  main_of_program = main;
  return next_function<decltype(&__libc_start_main)>("__libc_start_main")(armed_main, argc, argv, init, fini, end,
                                                                          stack);
}

std::FILE* fopen(const char* name, const char* mode)
{
  if(fails(FOPEN))
  {
    errno = EACCES;
    return nullptr;
  }
  return next_function<decltype(&fopen)>("fopen")(name, mode);
}

std::size_t fwrite(const void* data, std::size_t size, std::size_t n, std::FILE* file)
{
  if(fails(FWRITE))
  {
    errno = ENOSPC;
    return 0;
  }
  return next_function<decltype(&fwrite)>("fwrite")(data, size, n, file);
}

int fclose(std::FILE* file)
{
  const bool has_failed = fails(FCLOSE);
  const int result = next_function<decltype(&fclose)>("fclose")(file);
  if(!has_failed)
    return result;
  errno = ENOSPC;
  return EOF;
}

int rename(const char* from, const char* to)
{
  if(fails(RENAME))
  {
    errno = EACCES;
    return -1;
  }
  return next_function<decltype(&rename)>("rename")(from, to);
}

int mkdir(const char* name, mode_t mode)
{
  if(fails(MKDIR))
  {
    errno = EACCES;
    return -1;
  }
  return next_function<decltype(&mkdir)>("mkdir")(name, mode);
}

int remove(const char* name)
{
  if(fails(REMOVE))
  {
    errno = EACCES;
    return -1;
  }
  return next_function<decltype(&remove)>("remove")(name);
}
}

void* operator new(std::size_t size)
{
  if(fails(NEW))
    throw std::bad_alloc();
  if(void* const result = std::malloc(size == 0 ? 1 : size))
    return result;
  throw std::bad_alloc();
}

void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
