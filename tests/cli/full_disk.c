// A disk that is full, for a program under test (LD_PRELOAD): once GEARFILM_DISK_BYTES have been written to files below
// GEARFILM_DISK, every further write fails there, and the file system has no space left.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/statvfs.h>
#include <sys/uio.h>
#include <unistd.h>

static long left_over = -1;
static int full = 0;

static int takes(int file, size_t size) {
  const char* disk = getenv("GEARFILM_DISK");
  char link[64], path[4096];
  if (!disk) return 1;
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 1;
  path[length] = 0;
  if (strncmp(path, disk, strlen(disk)) != 0) return 1;
  if (left_over < 0) left_over = atol(getenv("GEARFILM_DISK_BYTES"));
  if (full || (long)size > left_over) {
    full = 1;
    errno = ENOSPC;
    return 0;
  }
  left_over -= (long)size;
  return 1;
}

ssize_t write(int file, const void* data, size_t size) {
  ssize_t (*real)(int, const void*, size_t) = dlsym(RTLD_NEXT, "write");
  return takes(file, size) ? real(file, data, size) : -1;
}

ssize_t writev(int file, const struct iovec* parts, int count) {
  ssize_t (*real)(int, const struct iovec*, int) = dlsym(RTLD_NEXT, "writev");
  size_t size = 0;
  for (int n = 0; n < count; ++n) size += parts[n].iov_len;
  return takes(file, size) ? real(file, parts, count) : -1;
}

ssize_t pwrite(int file, const void* data, size_t size, off_t offset) {
  ssize_t (*real)(int, const void*, size_t, off_t) = dlsym(RTLD_NEXT, "pwrite");
  return takes(file, size) ? real(file, data, size, offset) : -1;
}

ssize_t pwrite64(int file, const void* data, size_t size, off64_t offset) {
  ssize_t (*real)(int, const void*, size_t, off64_t) = dlsym(RTLD_NEXT, "pwrite64");
  return takes(file, size) ? real(file, data, size, offset) : -1;
}

int statvfs(const char* path, struct statvfs* space) {
  int (*real)(const char*, struct statvfs*) = dlsym(RTLD_NEXT, "statvfs");
  const int result = real(path, space);
  if (full) space->f_bavail = space->f_bfree = 0;
  return result;
}
