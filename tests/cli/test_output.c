/* test_output.c - a write to a pipe can be ended by a signal. */
#include "cli/output.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "tests/lib/near.h"

/* Writes to a file that is not regular, as to a pipe, and gets a signal. */
static void write_and_get(int signal_number)
{
    struct pp_output output;
    signal(SIGINT, SIG_DFL); /* a shell's job in the background ignores it */
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

/* Before that, a signal is a request to stop. */
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
        cmocka_unit_test(a_signal_before_it_is_noted),
    };
    add_tests(tests, NULL, NULL);
}
