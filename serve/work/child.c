/* child.c - see child.h. */
#include "serve/work/child.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "serve/server_clock.h"

extern char **environ;

static const size_t output_most = (size_t)48 << 20, errors_most = (size_t)64 << 10;
static const rlim_t memory_most = (rlim_t)4 << 30; /* limit on the address space of the
                                                    * child, including thread stacks and
                                                    * fonts */

struct pipes {
    int in[2], out[2], err[2];
};

static void close_end(int *end)
{
    if (*end >= 0)
        close(*end);
    *end = -1;
}

static void close_pipes(struct pipes *pipes)
{
    for (int i = 0; i < 2; i++) {
        close_end(&pipes->in[i]);
        close_end(&pipes->out[i]);
        close_end(&pipes->err[i]);
    }
}

static bool open_pipes(struct pipes *pipes)
{
    *pipes = (struct pipes){{-1, -1}, {-1, -1}, {-1, -1}};
    return pipe2(pipes->in, O_CLOEXEC) == 0 && pipe2(pipes->out, O_CLOEXEC) == 0
           && pipe2(pipes->err, O_CLOEXEC) == 0;
}

static bool spawn_child(pid_t *child, const struct pp_task *task,
                        const char *const *words, const struct pipes *pipes)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t none, standard;
    sigemptyset(&none);
    sigemptyset(&standard);
    sigaddset(&standard, SIGPIPE);
    sigaddset(&standard, SIGTERM);
    sigaddset(&standard, SIGINT);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipes->in[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes->out[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipes->err[1], STDERR_FILENO);
    /* The working directory must not contain any files of the user. */
    posix_spawn_file_actions_addchdir_np(&actions, "/proc/self/fdinfo");
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &standard);
    posix_spawnattr_setpgroup(&attributes, 0); /* separate process group, so that Ctrl-C
                                                * in the terminal does not reach the
                                                * child */
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF
                                              | POSIX_SPAWN_SETPGROUP);
    int failed = posix_spawn(child, task->server->options->program, &actions,
                             &attributes, (char *const *)(uintptr_t)words, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (failed)
        return false;
    const struct rlimit memory = {memory_most, memory_most},
                        seconds = {PP_CHILD_SECONDS_MOST * 4,
                                   PP_CHILD_SECONDS_MOST * 4},
                        core = {0, 0};
    prlimit(*child, RLIMIT_AS, &memory, NULL);
    prlimit(*child, RLIMIT_CPU, &seconds, NULL);
    prlimit(*child, RLIMIT_CORE, &core, NULL);
    setpriority(PRIO_PROCESS, (id_t)*child, 10);
    return true;
}

/* Appends one block of output to *bytes. Closes the pipe at the end of the output or
 * after a read error. Returns false if the output exceeds `most` bytes, or memory is
 * exhausted. */
static bool take_output(int *pipe, char **bytes, size_t *length, size_t most)
{
    enum { BLOCK = 64 << 10 };
    char *grown = realloc(*bytes, *length + BLOCK + 1);
    if (!grown)
        return false;
    *bytes = grown;
    ssize_t count = read(*pipe, grown + *length, BLOCK);
    if (count > 0)
        *length += (size_t)count;
    else if (count == 0 || errno != EINTR)
        close_end(pipe);
    grown[*length] = '\0';
    return *length <= most;
}

/* Writes the input, and reads standard output and standard error to their ends. */
static enum pp_child_end pump(struct pp_child_result *result, struct pp_task *task,
                              struct pipes *pipes, const char *input, size_t left)
{
    double last = pp_server_clock() + PP_CHILD_SECONDS_MOST;
    fcntl(pipes->in[1], F_SETFL, O_NONBLOCK);
    while (pipes->out[0] >= 0 || pipes->err[0] >= 0) {
        struct pollfd ends[] = {{.fd = pipes->out[0], .events = POLLIN},
                                {.fd = pipes->err[0], .events = POLLIN},
                                {.fd = pipes->in[1], .events = POLLOUT}};
        if (left == 0)
            close_end(&pipes->in[1]);
        ends[2].fd = pipes->in[1];
        poll(ends, 3, 40);
        if (pp_task_is_cancelled(task))
            return PP_CHILD_CANCELLED;
        if (pp_server_clock() > last)
            return PP_CHILD_LIMIT;
        if ((ends[0].revents
             && !take_output(&pipes->out[0], &result->output, &result->length,
                             output_most))
            || (ends[1].revents
                && !take_output(&pipes->err[0], &result->errors, &result->error_length,
                                errors_most)))
            return PP_CHILD_LIMIT;
        if (ends[2].revents) {
            ssize_t written = write(pipes->in[1], input, left);
            if (written > 0) {
                input += written;
                left -= (size_t)written;
            } else if (errno != EAGAIN && errno != EINTR) {
                close_end(&pipes->in[1]); /* the child has closed its input */
            }
        }
    }
    return PP_CHILD_DONE;
}

struct pp_child_result pp_child_run(struct pp_task *task, const char *const *words,
                                    const char *input, size_t input_length)
{
    struct pp_child_result result = {.end = PP_CHILD_FAILED};
    struct pipes pipes;
    pid_t child;
    int status;
    if (open_pipes(&pipes) && spawn_child(&child, task, words, &pipes)) {
        close_end(&pipes.in[0]);
        close_end(&pipes.out[1]);
        close_end(&pipes.err[1]);
        result.end = pump(&result, task, &pipes, input, input_length);
        if (result.end != PP_CHILD_DONE)
            kill(-child, SIGKILL);
        while (waitpid(child, &status, 0) < 0 && errno == EINTR)
            continue;
        if (result.end == PP_CHILD_DONE && !WIFEXITED(status))
            result.end = PP_CHILD_FAILED;
        result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    close_pipes(&pipes);
    return result;
}

const char *pp_child_sentence(struct pp_child_result *result)
{
    if (result->end == PP_CHILD_LIMIT)
        return "the command took too long, or its result was too large";
    /* A message begins with "pepperpot: " or "pepperpot COMMAND: ". */
    char *sentence = result->errors ? strstr(result->errors, "pepperpot") : NULL;
    sentence = sentence ? strstr(sentence, ": ") : NULL;
    if (!sentence)
        return "the command failed";
    sentence += 2;
    sentence[strcspn(sentence, "\n")] = '\0';
    return sentence;
}
