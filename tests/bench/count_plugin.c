/*
 * A QEMU plug-in that counts the instructions a chip executes, apart for each region of a program and each function.
 *
 * A region begins when the instruction at one of the given addresses is executed and ends where the next begins; the
 * program starts in region 0. Arguments:
 *   region=ADDRESS     the first begins region 0, the next region 1, ... (hexadecimal, at most 8)
 *   symbols=FILE       lines `address name` in order of addresses (hexadecimal); each name is counted apart
 *   out=FILE           where the counts go
 *   limit=N            give up when the program takes more than N instructions (default: never)
 *
 * The file lists `limit` (when it was reached), `region I COUNT CALLS` and `function I NAME COUNT`.
 * QEMU 7.2, plug-in interface 1. Debian has no package with qemu-plugin.h, so what is used of it is declared here.
 */
#include <inttypes.h>
#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

typedef uint64_t qemu_plugin_id_t;
typedef struct qemu_info_t qemu_info_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum qemu_plugin_op {
  QEMU_PLUGIN_INLINE_ADD_U64
};
enum qemu_plugin_cb_flags {
  QEMU_PLUGIN_CB_NO_REGS
};
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id,
                                           void (*translated)(qemu_plugin_id_t, struct qemu_plugin_tb *));
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, void (*end)(qemu_plugin_id_t, void *), void *user);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *insn, void (*executed)(unsigned, void *),
                                            enum qemu_plugin_cb_flags flags, void *user);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *insn, enum qemu_plugin_op op,
                                                void *counter, uint64_t add);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *insn);

#define EXPORT __attribute__((visibility("default")))
EXPORT int qemu_plugin_version = 1;
EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char **argv);

enum {
  REGIONS_MAX = 8,
  NAME_MAX_LENGTH = 200
};

typedef struct function {
  uint64_t address;
  char name[NAME_MAX_LENGTH];
  uint64_t count;      /* since the program began: what the emulated code adds to */
  uint64_t count_seen; /* `count` when the current region began */
  uint64_t in_region[REGIONS_MAX];
} function;

static uint64_t region_address[REGIONS_MAX], region_count[REGIONS_MAX], region_calls[REGIONS_MAX];
static size_t regions, current;
static function *functions; /* the first has address 0: what lies below all symbols */
static size_t function_count;
static uint64_t limit = UINT64_MAX, total_seen;
static volatile uint64_t total; /* what the emulated code adds to; the watch reads it */
static const char *out_path;

static void write_counts(bool limited) {
  FILE *out = fopen(out_path, "w");
  size_t i, r;
  if (out == NULL) {
    fprintf(stderr, "count_plugin: cannot write %s\n", out_path);
    exit(2);
  }
  if (limited) fprintf(out, "limit\n");
  for (r = 0; r < regions; r++)
    fprintf(out, "region %zu %" PRIu64 " %" PRIu64 "\n", r, region_count[r], region_calls[r]);
  for (i = 0; i < function_count; i++)
    for (r = 0; r < regions; r++)
      if (functions[i].in_region[r] != 0)
        fprintf(out, "function %zu %s %" PRIu64 "\n", r, functions[i].name, functions[i].in_region[r]);
  fclose(out);
}

/* Books what has been counted since the last change of region. */
static void settle(void) {
  size_t i;
  for (i = 0; i < function_count; i++) {
    functions[i].in_region[current] += functions[i].count - functions[i].count_seen;
    functions[i].count_seen = functions[i].count;
  }
  region_count[current] += total - total_seen;
  total_seen = total;
}

static void region_begins(unsigned cpu, void *user) {
  (void)cpu;
  settle();
  current = (size_t)(uintptr_t)user;
  region_calls[current]++;
}

/* Ends a program that is over its limit. When it looks is chance; that such a program ends as limited is not, as the
 * last instruction's count is looked at too. */
static void *watch(void *user) {
  const struct timespec pause = {0, 20000000};
  (void)user;
  while (total <= limit) nanosleep(&pause, NULL);
  write_counts(true);
  _exit(0);
}

/* The function that an address lies in. */
static function *function_at(uint64_t address) {
  size_t low = 0, high = function_count;
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    if (functions[middle].address <= address)
      low = middle;
    else
      high = middle;
  }
  return &functions[low];
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *tb) {
  const size_t count = qemu_plugin_tb_n_insns(tb);
  size_t i, r;
  (void)id;
  for (i = 0; i < count; i++) {
    struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
    const uint64_t address = qemu_plugin_insn_vaddr(insn);
    for (r = 0; r < regions; r++)
      if (address == region_address[r])
        qemu_plugin_register_vcpu_insn_exec_cb(insn, region_begins, QEMU_PLUGIN_CB_NO_REGS,
                                               (void *)(uintptr_t)r);
    qemu_plugin_register_vcpu_insn_exec_inline(insn, QEMU_PLUGIN_INLINE_ADD_U64, (void *)&total, 1);
    if (function_count > 0)
      qemu_plugin_register_vcpu_insn_exec_inline(insn, QEMU_PLUGIN_INLINE_ADD_U64,
                                                 &function_at(address)->count, 1);
  }
}

static void ended(qemu_plugin_id_t id, void *user) {
  (void)id;
  (void)user;
  settle();
  write_counts(total > limit);
}

static bool add_function(uint64_t address, const char *name) {
  function *grown;
  if (function_count > 0 && address < functions[function_count - 1].address) return false;
  grown = realloc(functions, (function_count + 1) * sizeof *functions);
  if (grown == NULL) return false;
  functions = grown;
  memset(&functions[function_count], 0, sizeof *functions);
  functions[function_count].address = address;
  snprintf(functions[function_count].name, NAME_MAX_LENGTH, "%s", name);
  function_count++;
  return true;
}

static bool read_symbols(const char *path) {
  FILE *file = fopen(path, "r");
  char name[NAME_MAX_LENGTH];
  uint64_t address;
  bool good = file != NULL && add_function(0, "?");
  while (good && fscanf(file, "%" SCNx64 " %199s", &address, name) == 2) good = add_function(address, name);
  good = good && feof(file);
  if (file != NULL) fclose(file);
  return good;
}

static bool read_argument(const char *argument) {
  if (strncmp(argument, "region=", 7) == 0) {
    if (regions == REGIONS_MAX) return false;
    region_address[regions++] = strtoull(argument + 7, NULL, 16);
    return true;
  }
  if (strncmp(argument, "symbols=", 8) == 0) return read_symbols(argument + 8);
  if (strncmp(argument, "out=", 4) == 0) return (out_path = strdup(argument + 4)) != NULL;
  if (strncmp(argument, "limit=", 6) == 0) return (limit = strtoull(argument + 6, NULL, 10)) > 0;
  return false;
}

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t *info, int argc, char **argv) {
  pthread_t watcher;
  int i;
  (void)info;
  for (i = 0; i < argc; i++)
    if (!read_argument(argv[i])) {
      fprintf(stderr, "count_plugin: bad argument %s\n", argv[i]);
      return 1;
    }
  if (regions == 0 || out_path == NULL) {
    fprintf(stderr, "count_plugin: region=ADDRESS and out=FILE are needed\n");
    return 1;
  }
  if (limit != UINT64_MAX && pthread_create(&watcher, NULL, watch, NULL) != 0) {
    fprintf(stderr, "count_plugin: cannot watch the limit\n");
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
  qemu_plugin_register_atexit_cb(id, ended, NULL);
  return 0;
}
