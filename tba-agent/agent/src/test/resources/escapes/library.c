/* A library by the name of one that the programs before a component need: runs with their rights. */
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

__attribute__((constructor)) static void loaded(void) {
  const char *mark = getenv("MARK");
  if (mark) close(open(mark, O_CREAT | O_WRONLY, 0666));
}
