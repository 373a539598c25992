/* progress.c - draws the progress bar, with the remaining time, over the previous
 * bar. */
#include "cli/progress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "reports/parts/format.h"
#include "model/base/clock.h"

/* Greatest width of the bar and of the label, and least width of the bar, in
 * columns. */
enum { BAR = 24, LABEL = 20, BAR_LEAST = 5 };

void pp_progress_begin(struct pp_progress *progress, const char *label, bool quiet)
{
    double now = pp_clock_s();
    *progress = (struct pp_progress){.shown = !quiet && isatty(STDERR_FILENO),
                                     .started_s = now,
                                     .last_s = now,
                                     .label = label ? label : "room"};
}

void pp_progress_resume(struct pp_progress *progress, double done)
{
    progress->before = done;
}

/* Writes the remaining time as ", 8 s left", ", 3 min left" or ", 2.5 h left"; "" if it
 * is unknown (NAN). */
static void say_left(char *text, size_t room, double seconds)
{
    text[0] = '\0';
    if (isnan(seconds))
        return;
    if (seconds < 99.5)
        snprintf(text, room, ", %.0f s left", ceil(seconds));
    else if (seconds < 5970.0)
        snprintf(text, room, ", %.0f min left", seconds / 60.0);
    else
        snprintf(text, room, ", %.*f h left", seconds < 99.5 * 3600.0 ? 1 : 0,
                 fmin(seconds / 3600.0, 99999.0));
}

/* Prints the label, cut to a number of columns. Returns the number of columns used. */
static int put_label(FILE *out, const char *label, int columns)
{
    char start[4 * LABEL + 1];
    size_t length = 0;
    for (;;) {
        size_t next = (size_t)pp_format_utf8_length(label + length);
        if (next == 0 || length + next >= sizeof start)
            break;
        memcpy(start + length, label + length, next);
        start[length + next] = '\0';
        if (pp_format_utf8_width(start) > columns)
            break;
        length += next;
    }
    start[length] = '\0';
    pp_format_utf8_put(out, start);
    return pp_format_utf8_width(start);
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

void pp_progress_print(FILE *out, const char *label, double done, double error,
                       double left_s, int columns)
{
    static const char full[] = "========================";
    char tail[64], left[32];
    say_left(left, sizeof left, left_s);
    int tail_width =
        isfinite(error)
            ? snprintf(tail, sizeof tail, "%3.0f %%, error %.2g %%%s",
                       floor(100.0 * done), 100.0 * error, left)
            : snprintf(tail, sizeof tail, "%3.0f %%%s", floor(100.0 * done), left);
    /* The bar is shortened first, then the label. The last column remains empty, since
     * some terminals would wrap the line. */
    int spare = columns - 1 - tail_width;
    spare -= put_label(out, label, least(spare - 1, LABEL)) + 1;
    if (spare >= 3 + BAR_LEAST) {
        int bar = least(spare - 3, BAR), filled = (int)(done * bar);
        fprintf(out, " [%.*s%*s]", filled, full, bar - filled, "");
    }
    fprintf(out, " %s", tail);
}

/* Number of columns of the terminal; 80 if unknown. */
static int terminal_columns(void)
{
    struct winsize size;
    bool told = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return told ? size.ws_col : 80;
}

void pp_progress_show(struct pp_progress *progress, double done, double error)
{
    double now = pp_clock_s();
    if (!progress->shown || now - progress->last_s < 0.1)
        return;
    progress->last_s = now;
    done = fmin(fmax(done, 0.0), 1.0);
    double elapsed = now - progress->started_s, left = NAN;
    if (done > progress->before && elapsed > 0.3)
        left = elapsed * (1.0 - done) / (done - progress->before);
    fputs("\r\033[K", stderr);
    pp_progress_print(stderr, progress->label, done, error, left, terminal_columns());
    fflush(stderr);
}

void pp_progress_end(struct pp_progress *progress)
{
    if (progress->shown)
        fputs("\r\033[K", stderr);
    progress->shown = false;
}
