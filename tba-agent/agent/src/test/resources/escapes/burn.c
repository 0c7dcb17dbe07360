/* Uses the processors with the given number of threads or processes, each in its own session. */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void *burn(void *argument) {
  for (volatile unsigned long i = 0;; i++) {
  }
  return argument;
}

int main(int argc, char **argv) {
  int number = argc > 2 ? atoi(argv[2]) : 1;
  for (int i = 1; i < number; i++) {
    pthread_t thread;
    if (strcmp(argv[1], "threads") == 0) pthread_create(&thread, NULL, burn, NULL);
    else if (fork() == 0) {
      setsid();
      burn(NULL);
    }
  }
  burn(NULL);
}
