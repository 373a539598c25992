/* job_store.c - see job_store.h. */
#include "serve/stores/job_store.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <unistd.h>

#include "serve/answers/answer_program.h"
#include "serve/work/work_line.h"

enum { NAME_DIGITS = 31, PATH_BYTES = 4096 };

static const char *const job_commands[] = {"df",     "assess", "size",  "availability",
                                           "report", "chart",  "annual"};

static void job_path(char path[PATH_BYTES], const struct pp_task *task,
                     const char *name, const char *extension)
{
    snprintf(path, PATH_BYTES, "%s/%s%s", task->server->options->jobs, name, extension);
}

/* Writes a file in one step. On failure no incomplete file is left. */
static bool write_whole(const struct pp_task *task, const char *name,
                        const char *extension, const char *bytes, size_t length)
{
    char path[PATH_BYTES], partial[PATH_BYTES];
    job_path(path, task, name, extension);
    job_path(partial, task, name, ".partial");
    FILE *out = fopen(partial, "we");
    bool good = out && fwrite(bytes, 1, length, out) == length;
    if (out && fclose(out) != 0)
        good = false;
    good = good && rename(partial, path) == 0;
    if (!good)
        unlink(partial);
    return good;
}

static bool write_state(const struct pp_task *task, const char *name, const char *state)
{
    struct json_object *object = json_object_new_object();
    json_object_object_add(object, "job", json_object_new_string(name));
    json_object_object_add(object, "command", json_object_new_string(task->command));
    json_object_object_add(object, "state", json_object_new_string(state));
    json_object_object_add(object, "status", json_object_new_int((int)task->status));
    json_object_object_add(object, "type",
                           json_object_new_string(task->type ? task->type : ""));
    const char *text = json_object_to_json_string(object);
    bool good = write_whole(task, name, ".json", text, strlen(text));
    json_object_put(object);
    return good;
}

/* Runs the job. The request that started it has already been answered. */
static bool run_job(struct pp_task *task)
{
    const char *name = task->state;
    write_state(task, name, "working");
    pp_answer_program(task);
    bool kept = task->status && task->bytes
                && write_whole(task, name, ".result", task->bytes, task->length);
    write_state(task, name,
                kept ? task->status == MHD_HTTP_OK ? "done" : "failed" : "stopped");
    return true;
}

static const char *job_command(const char *wanted)
{
    for (size_t i = 0; i < sizeof job_commands / sizeof *job_commands; i++)
        if (wanted && strcmp(job_commands[i], wanted) == 0)
            return job_commands[i];
    return NULL;
}

static char *new_name(void)
{
    unsigned char random[16];
    char *name = malloc(2 * sizeof random + 1);
    if (name && getrandom(random, sizeof random, 0) == (ssize_t)sizeof random) {
        for (size_t i = 0; i < sizeof random; i++)
            snprintf(name + 2 * i, 3, "%02x", random[i]);
        name[NAME_DIGITS] = '\0'; /* names must fit the variable part of a path (struct
                                   * pp_task) */
        return name;
    }
    free(name);
    return NULL;
}

static bool has_jobs(struct pp_task *task)
{
    if (task->server->options->jobs)
        return true;
    pp_task_fail(task, MHD_HTTP_NOT_FOUND,
                 "this server does not store jobs; start it with --jobs to allow them");
    return false;
}

bool pp_job_store_put(struct pp_task *task)
{
    struct json_object *wanted = NULL, *kind = NULL, *body = NULL;
    if (!has_jobs(task))
        return true;
    json_object_object_get_ex(task->body, "command", &wanted);
    json_object_object_get_ex(task->body, "kind", &kind);
    const char *command = job_command(json_object_get_string(wanted));
    if (!command) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                     "command: expected df, assess, size, availability, annual, report "
                     "or chart");
        return true;
    }
    char *name = new_name();
    struct pp_task *job = NULL;
    if (name && json_object_deep_copy(task->body, &body, NULL) == 0)
        job = pp_task_create(task->server, run_job, command, body);
    if (!job) {
        free(name);
        pp_task_fail(task, MHD_HTTP_INTERNAL_SERVER_ERROR, "out of memory");
        return true;
    }
    job->state = name;
    job->free_state = free;
    job->client = task->client;
    const char *kind_text = json_object_get_string(kind);
    if (kind_text
        && strspn(kind_text, "abcdefghijklmnopqrstuvwxyz-") == strlen(kind_text))
        snprintf(job->kind, sizeof job->kind, "%s", kind_text);
    struct json_object *answer = json_object_new_object();
    json_object_object_add(answer, "job", json_object_new_string(name));
    if (!write_state(job, name, "waiting")) {
        pp_task_fail(task, MHD_HTTP_INSUFFICIENT_STORAGE, "the job cannot be stored");
        json_object_put(answer);
    } else if (pp_work_line_submit(task->server->programs, job) != PP_WORK_LINE_TAKEN) {
        pp_task_fail(task, MHD_HTTP_SERVICE_UNAVAILABLE,
                     "the server is busy; try again later");
        json_object_put(answer);
    } else {
        pp_task_answer_json(task, MHD_HTTP_ACCEPTED, answer);
    }
    pp_task_release(job);
    return true;
}

static char *read_job_file(const char *path, size_t *length)
{
    char *bytes = NULL;
    FILE *in = fopen(path, "re");
    FILE *out = in ? open_memstream(&bytes, length) : NULL;
    char block[16 << 10];
    size_t count;
    while (out && (count = fread(block, 1, sizeof block, in)) > 0)
        fwrite(block, 1, count, out);
    if (out)
        fclose(out);
    if (in)
        fclose(in);
    return bytes;
}

/* Media type named in the state file. Static string. */
static const char *result_type(struct json_object *state)
{
    static const char *const types[] = {
        "application/json",        "text/plain; charset=utf-8",
        "text/csv; charset=utf-8", "image/svg+xml",
        "application/pdf",         "image/png",
        "text/html; charset=utf-8"};
    struct json_object *type = NULL;
    json_object_object_get_ex(state, "type", &type);
    for (size_t i = 0; type && i < sizeof types / sizeof *types; i++)
        if (strcmp(types[i], json_object_get_string(type)) == 0)
            return types[i];
    return "application/octet-stream";
}

bool pp_job_store_get(struct pp_task *task)
{
    char path[PATH_BYTES];
    size_t length;
    if (!has_jobs(task))
        return true;
    bool is_name = strlen(task->kind) == NAME_DIGITS
                   && strspn(task->kind, "0123456789abcdef") == NAME_DIGITS;
    job_path(path, task, task->kind, ".json");
    char *text = is_name ? read_job_file(path, &length) : NULL;
    struct json_object *state = text ? json_tokener_parse(text) : NULL, *word = NULL;
    json_object_object_get_ex(state, "state", &word);
    if (!word) {
        pp_task_fail(task, MHD_HTTP_NOT_FOUND, "there is no such job");
    } else if (strcmp(json_object_get_string(word), "done") == 0) {
        job_path(path, task, task->kind, ".result");
        char *bytes = read_job_file(path, &length);
        pp_task_answer(task, MHD_HTTP_OK, result_type(state), bytes, length);
    } else {
        json_object_get(state);
        pp_task_answer_json(task, MHD_HTTP_ACCEPTED, state);
    }
    json_object_put(state);
    free(text);
    return true;
}
