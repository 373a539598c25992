/* cmd_doctor.c - the command doctor: lists the parts of this installation, tests them,
 * and draws a page for checking a printer. */
#include "config.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/doctor/doctor_checks.h"
#include "cli/doctor/doctor_places.h"
#include "cli/message.h"
#include "cli/output.h"

static const char about[] =
    "Reports what this installation includes, and tests its parts: a known daylight "
    "factor by hand and by simulation, threads, drawings, fonts and files. With -o it "
    "also draws a test page with rulers, greys, lines and hatches, to check a "
    "printer.\n\nThe exit status is 0 if all checks pass, else 3.";

struct doctor_options {
    const char *output;
    enum pp_chart_format format; /* format of the test page */
};

static const struct pp_option page_options[] = {
    {"output", 'o', "FILE", "Draw the test page to FILE.pdf, FILE.svg or FILE.png.",
     pp_options_read_output, offsetof(struct doctor_options, output)},
    {0},
};

static void init_doctor(void *values)
{
    *(struct doctor_options *)values = (struct doctor_options){0};
}

static enum pp_status check_doctor(void *values, char **words, int count,
                                   struct pp_error *err)
{
    struct doctor_options *options = values;
    if (count > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "\"%s\" is not an option; expected no argument, or -o FILE.pdf, "
                       "FILE.svg or FILE.png",
                       words[0]);
    return options->output ? pp_canvas_format_of(&options->format, options->output, err)
                           : PP_OK;
}

static enum pp_status write_test_page(const struct doctor_options *options,
                                      struct pp_error *err)
{
    struct pp_canvas *canvas = NULL;
    struct pp_output output;
    const unsigned char *bytes;
    size_t length;
    enum pp_status status = pp_output_open(&output, options->output, err);
    if (status == PP_OK)
        status = pp_doctor_checks_page(&canvas, &bytes, &length, options->format, err);
    if (status == PP_OK)
        status = pp_output_put(output.stream, bytes, length, err);
    status = pp_output_close(&output, status, err);
    pp_canvas_destroy(canvas);
    return status;
}

/* Prints the checks. Returns the number of failed checks. */
static int print_checks(void)
{
    struct pp_doctor_check list[PP_DOCTOR_CHECK_COUNT];
    int failed = 0;
    pp_doctor_checks_run(list);
    puts("\nChecks");
    for (int i = 0; i < PP_DOCTOR_CHECK_COUNT; i++) {
        char text[sizeof list[i].result + 16];
        snprintf(text, sizeof text, "%s %s",
                 list[i].passes ? "ok:" : "FAILED:", list[i].result);
        pp_doctor_places_line(list[i].name, text, stdout);
        failed += !list[i].passes;
    }
    return failed;
}

static enum pp_exit run_doctor(void *values, char **words, int count)
{
    (void)words, (void)count;
    const struct doctor_options *options = values;
    struct pp_error err;
    puts(PACKAGE_NAME " " PACKAGE_VERSION "\n\nInstallation");
    pp_doctor_places_print(stdout);
    pp_doctor_places_line("libraries", PP_LIBRARIES, stdout);
#ifdef HAVE_MICROHTTPD
    pp_doctor_places_line("web server", "yes", stdout);
#else
    pp_doctor_places_line(
        "web server",
        "no; install libmicrohttpd and build again to use pepperpot serve", stdout);
#endif
    puts("\nRadiance, for validate radiance");
    pp_doctor_places_print_radiance(stdout);
    int failed = print_checks();
    if (options->output) {
        if (write_test_page(options, &err) != PP_OK)
            return pp_message_error(&err);
        printf("\nTest page: %s\n", options->output);
    }
    if (failed == 0)
        return PP_EXIT_DONE;
    pp_message("%d of %d checks failed; parts of this installation do not work", failed,
               PP_DOCTOR_CHECK_COUNT);
    return PP_EXIT_MACHINE;
}

static void clear_doctor(void *values)
{
    (void)values;
}

static const struct pp_option_group groups[] = {
    {"Test page", page_options, 0},
    {0},
};

const struct pp_command pp_command_doctor = {
    .name = "doctor",
    .summary = "what this installation includes, and a test page",
    .operands = "",
    .about = about,
    .groups = groups,
    .size = sizeof(struct doctor_options),
    .init = init_doctor,
    .check = check_doctor,
    .run = run_doctor,
    .clear = clear_doctor,
};
