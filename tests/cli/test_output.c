/* test_output.c - a signal can end a write to a pipe. */
#include "cli/output.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "tests/lib/near.h"

/* Writes to a file that is not regular, such as a pipe, and receives a signal. */
static void write_and_get(int signal_number)
{
    struct pp_output output;
    signal(SIGINT, SIG_DFL); /* a background job of a shell ignores it */
    pp_interrupt_watch();
    if (pp_output_open(&output, "/dev/null", NULL) != PP_OK)
        _exit(1);
    fputs("results", output.stream);
    if (pp_output_commit(&output, NULL) != PP_OK)
        _exit(2);
    raise(signal_number);
    _exit(3);
}

static void a_signal_ends_a_program_that_writes_to_a_pipe(void **state)
{
    (void)state;
    static const int signals[] = {SIGINT, SIGTERM};
    for (int i = 0; i < 2; i++) {
        pid_t child = fork();
        if (child == 0)
            write_and_get(signals[i]);
        int status;
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), signals[i]);
    }
}

/* Opening a pipe without a reader also waits. */
static void a_signal_ends_a_program_whose_pipe_has_no_reader(void **state)
{
    (void)state;
    char folder[] = "/tmp/test_output-XXXXXX", pipe[64];
    assert_non_null(mkdtemp(folder));
    snprintf(pipe, sizeof pipe, "%s/pipe", folder);
    assert_int_equal(mkfifo(pipe, 0600), 0);
    pid_t child = fork();
    if (child == 0) {
        struct pp_output output;
        signal(SIGALRM, SIG_DFL);
        signal(SIGTERM, SIG_DFL);
        pp_interrupt_watch();
        alarm(4);
        if (pp_output_open(&output, pipe, NULL) != PP_OK)
            _exit(1);
        pp_output_commit(&output, NULL);
        _exit(2);
    }
    usleep(300000);
    kill(child, SIGTERM);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    unlink(pipe);
    rmdir(folder);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), SIGTERM);
}

/* The second output cannot be written: its temporary file cannot be created. */
static void a_failure_leaves_all_old_files(void **state)
{
    (void)state;
    char folder[] = "/tmp/test_output-XXXXXX", path[2][64], line[8] = "";
    assert_non_null(mkdtemp(folder));
    struct pp_output outputs[2];
    for (int i = 0; i < 2; i++) {
        char inner[48];
        snprintf(inner, sizeof inner, "%s/%d", folder, i);
        assert_int_equal(mkdir(inner, 0700), 0);
        snprintf(path[i], sizeof path[i], "%s/chart", inner);
        FILE *old = fopen(path[i], "w");
        assert_non_null(old);
        fputs("old", old);
        fclose(old);
        assert_int_equal(pp_output_open(&outputs[i], path[i], NULL), PP_OK);
        fputs("new", outputs[i].stream);
    }
    unlink(path[1]);
    path[1][strlen(path[1]) - strlen("/chart")] = '\0';
    rmdir(path[1]);
    assert_int_equal(pp_output_commit_all(outputs, 2, NULL), PP_SYSTEM);
    FILE *kept = fopen(path[0], "r");
    assert_non_null(kept);
    assert_non_null(fgets(line, sizeof line, kept));
    fclose(kept);
    unlink(path[0]);
    path[0][strlen(path[0]) - strlen("/chart")] = '\0';
    assert_int_equal(rmdir(path[0]), 0); /* no temporary file is left */
    rmdir(folder);
    assert_string_equal(line, "old");
}

/* Before the write, a signal only requests to stop. */
static void a_signal_before_it_is_noted(void **state)
{
    (void)state;
    pid_t child = fork();
    if (child == 0) {
        signal(SIGINT, SIG_DFL);
        pp_interrupt_watch();
        raise(SIGINT);
        _exit(pp_interrupt_came() ? 0 : 1);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_signal_ends_a_program_that_writes_to_a_pipe),
        cmocka_unit_test(a_signal_ends_a_program_whose_pipe_has_no_reader),
        cmocka_unit_test(a_failure_leaves_all_old_files),
        cmocka_unit_test(a_signal_before_it_is_noted),
    };
    add_tests(tests, NULL, NULL);
}
