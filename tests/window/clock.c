// A system clock that is off by as many seconds as stand in the file CLOCK_SHIFT, from one moment to the next.
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

int clock_gettime(clockid_t clock, struct timespec *time) {
  int answer = syscall(SYS_clock_gettime, clock, time);
  if (clock == CLOCK_REALTIME) {
    char text[32] = "";
    int file = open(getenv("CLOCK_SHIFT"), O_RDONLY);
    if (file >= 0 && read(file, text, sizeof text - 1) > 0) time->tv_sec += atoll(text);
    if (file >= 0) close(file);
  }
  return answer;
}
