/* bench_process.c - processor time and memory of complete runs of the command, from
 * start to end. */
#include <fcntl.h>
#include <math.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { RUNS = 30 };

struct run {
    double processor_s;
    double most_mib; /* peak resident memory */
};

static struct run run(char *const *words)
{
    struct rusage usage;
    int state = -1;
    pid_t child;
    posix_spawn_file_actions_t actions; /* posix_spawn, since a fork would count this
                                         * process's memory */
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    bool started = posix_spawn(&child, words[0], &actions, NULL, words, environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    if (!started || wait4(child, &state, 0, &usage) != child || state != 0) {
        fprintf(stderr, "bench: %s %s failed\n", words[0], words[1]);
        exit(3);
    }
    return (struct run){
        (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec)
            + 1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec),
        (double)usage.ru_maxrss / 1024.0};
}

static void bench(const char *what, const char *wanted, char *const *words)
{
    double best = INFINITY, sum = 0.0, most_mib = 0.0;
    for (int i = 0; i < RUNS; i++) {
        struct run one = run(words);
        best = fmin(best, one.processor_s);
        sum += one.processor_s;
        most_mib = fmax(most_mib, one.most_mib);
    }
    printf("%-46s %6.1f ms at best, %6.1f ms on average, %5.1f MiB%s\n", what,
           1e3 * best, 1e3 * sum / RUNS, most_mib, wanted);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    char *program = argc > 1 ? argv[1] : (char *)"./pepperpot";
    char *room = argc > 2 ? argv[2] : (char *)"../examples/deep-office.xml";
    char page[] = "bench_process.pdf";
#define WORDS(...) ((char *[]){program, __VA_ARGS__, NULL})
    printf("complete processes for the deep office, %d runs of each, one thread:\n",
           (int)RUNS);
    bench("--version", "", WORDS((char *)"--version"));
    bench("df, the usual methods", "",
          WORDS((char *)"df", (char *)"-j", (char *)"1", room));
    bench("df, all hand methods", " (target: 10 ms)",
          WORDS((char *)"df", (char *)"-j", (char *)"1", (char *)"-m", (char *)"all",
                room));
    bench("chart section", "",
          WORDS((char *)"chart", (char *)"section", (char *)"-o", page, room));
    bench("chart plan, with contours", " (target: 50 ms)",
          WORDS((char *)"chart", (char *)"plan", (char *)"-o", page, room));
    bench("chart plan, under ISO 12", " (target: 300 ms)",
          WORDS((char *)"chart", (char *)"plan", (char *)"--sky",
                (char *)"iso-12,35,180", (char *)"-o", page, room));
    bench("df --simulate, 17 points at 1 %", " (target: 64 MiB)",
          WORDS((char *)"df", (char *)"-q", (char *)"-j", (char *)"1",
                (char *)"--simulate", room));
    unlink(page);
    return 0;
}
