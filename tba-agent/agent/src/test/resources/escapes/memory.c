/* Takes memory in one of the ways in which a limit might not see it. Says TAKEN where it had all that it wanted. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <mqueue.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#define MIB (1UL << 20)
#define WANTED (3072UL)

static char block[MIB];

static void refused(const char *what) {
  printf("refused: %s: %s\n", what, strerror(errno));
  exit(1);
}

static void taken(void) {
  puts("TAKEN");
  fflush(stdout);
  sleep(20);
}

static int memfd(void) {
  int fd = (int)syscall(SYS_memfd_create, "x", 0);
  if (fd < 0) refused("memfd_create");
  return fd;
}

/* Files of 128 MiB without a name, each below any limit of a file's size. */
static void written(void) {
  for (unsigned long i = 0; i < WANTED / 128; i++) {
    int fd = memfd();
    for (int j = 0; j < 128; j++)
      if (write(fd, block, MIB) != (ssize_t)MIB) refused("write");
  }
}

static void touch(int flags, int fd) {
  char *p = mmap(NULL, 128 * MIB, PROT_READ | PROT_WRITE, flags, fd, 0);
  if (p == MAP_FAILED) refused("mmap");
  for (unsigned long i = 0; i < 128 * MIB; i += 4096) ((volatile char *)p)[i] = 1;
}

static void mapped(int flags) {
  for (unsigned long i = 0; i < WANTED / 128; i++) touch(flags, -1);
}

static void mapped_files(void) {
  for (unsigned long i = 0; i < WANTED / 128; i++) {
    int fd = memfd();
    if (ftruncate(fd, 128 * MIB)) refused("ftruncate");
    touch(MAP_SHARED, fd);
  }
}

/* Files of 32 MiB, each below any limit of a file's size. */
static void files(const char *folder) {
  for (unsigned long i = 0; i < WANTED / 32; i++) {
    char name[256];
    snprintf(name, sizeof name, "%s/%lu", folder, i);
    int fd = open(name, O_CREAT | O_RDWR, 0600);
    if (fd < 0) refused("open");
    for (int j = 0; j < 32; j++)
      if (write(fd, block, MIB) != (ssize_t)MIB) refused("write");
    close(fd);
  }
}

static void names(const char *folder) {
  for (unsigned long i = 0; i < 3000000; i++) {
    char name[256];
    snprintf(name, sizeof name, "%s/%lu", folder, i);
    int fd = open(name, O_CREAT | O_RDWR, 0600);
    if (fd < 0) refused("open");
    close(fd);
  }
}

static void segments(void) {
  for (unsigned long i = 0; i < WANTED / 64; i++) {
    int id = shmget(IPC_PRIVATE, 64 * MIB, IPC_CREAT | 0600);
    if (id < 0) refused("shmget");
    char *p = shmat(id, NULL, 0);
    if (p == (void *)-1) refused("shmat");
    memset(p, 1, 64 * MIB);
    shmdt(p);
  }
}

/* Up to 1 GiB: what the kernel lets a namespace have is less than 3. */
static void messages(void) {
  unsigned long bytes = 0;
  struct { long type; char text[8192]; } message = {1, {0}};
  for (int i = 0; i < 100000 && bytes < 1024 * MIB; i++) {
    int id = msgget(IPC_PRIVATE, IPC_CREAT | 0600);
    if (id < 0) refused("msgget");
    while (msgsnd(id, &message, sizeof message.text, IPC_NOWAIT) == 0) bytes += sizeof message.text;
  }
}

static void queues(void) {
  for (int i = 0; i < 2000; i++) {
    char name[32];
    snprintf(name, sizeof name, "/q%d", i);
    struct mq_attr attr = {.mq_maxmsg = 10, .mq_msgsize = 8192};
    if (mq_open(name, O_CREAT | O_RDWR, 0600, &attr) < 0) refused("mq_open");
  }
}

/* Four processes with full sockets; together beyond 1.5 GiB. */
static void sockets(void) {
  unsigned long *sum = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  for (int child = 0; child < 4; child++) {
    if (fork() == 0) {
      int ends[2];
      while (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0)
        for (int i = 0; i < 2; i++) {
          ssize_t n;
          while ((n = send(ends[i], block, 65536, MSG_DONTWAIT)) > 0) __sync_fetch_and_add(sum, (unsigned long)n);
        }
      sleep(20);
      _exit(0);
    }
  }
  for (int i = 0; i < 150 && *sum < 1200 * MIB; i++) usleep(100000);
  if (*sum < 1200 * MIB) refused("sockets");
}

static void children(void) {
  for (int child = 0; child < 8; child++) {
    if (fork() == 0) {
      for (int i = 0; i < 3; i++) touch(MAP_PRIVATE | MAP_ANONYMOUS, -1);
      sleep(20);
      _exit(0);
    }
  }
  sleep(5);
}

int main(int argc, char **argv) {
  const char *kind = argc > 1 ? argv[1] : "";
  memset(block, 1, sizeof block);
  if (!strcmp(kind, "memfd-written")) written();
  else if (!strcmp(kind, "memfd-mapped")) mapped_files();
  else if (!strcmp(kind, "shared")) mapped(MAP_SHARED | MAP_ANONYMOUS);
  else if (!strcmp(kind, "private")) mapped(MAP_PRIVATE | MAP_ANONYMOUS);
  else if (!strcmp(kind, "files")) files(argv[2]);
  else if (!strcmp(kind, "names")) names(argv[2]);
  else if (!strcmp(kind, "segments")) segments();
  else if (!strcmp(kind, "messages")) messages();
  else if (!strcmp(kind, "queues")) queues();
  else if (!strcmp(kind, "sockets")) sockets();
  else if (!strcmp(kind, "children")) children();
  else return 2;
  taken();
  return 0;
}
