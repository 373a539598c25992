#include "cli/progress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cli/utf8.h"
#include "model/clock.h"

enum { BAR = 24, LABEL = 20 };

void pp_progress_begin(struct pp_progress *progress, const char *label, bool quiet)
{
    double now = pp_clock_s();
    *progress = (struct pp_progress){.shown = !quiet && isatty(STDERR_FILENO),
                                     .started_s = now,
                                     .last_s = now,
                                     .label = label};
}

void pp_progress_resume(struct pp_progress *progress, double done)
{
    progress->before = done;
}

/* "8 s", "3 min", "2.5 h". */
static void put_time(double seconds)
{
    if (seconds < 99.5)
        fprintf(stderr, "%.0f s", ceil(seconds));
    else if (seconds < 5970.0)
        fprintf(stderr, "%.0f min", seconds / 60.0);
    else
        fprintf(stderr, "%.1f h", seconds / 3600.0);
}

static void put_label(const char *label)
{
    char start[4 * LABEL + 1];
    size_t length = 0;
    for (int width = 0; label[length] && width < LABEL; width++) {
        size_t next = (size_t)pp_utf8_length(label + length);
        if (length + next >= sizeof start)
            break;
        length += next;
    }
    memcpy(start, label, length);
    start[length] = '\0';
    pp_utf8_put(stderr, start);
}

void pp_progress_show(struct pp_progress *progress, double done, double error)
{
    double now = pp_clock_s();
    if (!progress->shown || now - progress->last_s < 0.1)
        return;
    progress->last_s = now;
    done = fmin(fmax(done, 0.0), 1.0);

    static const char full[] = "========================";
    int filled = (int)(done * BAR);
    fputs("\r\033[K", stderr);
    put_label(progress->label);
    fprintf(stderr, " [%.*s%*s] %3.0f %%", filled, full, BAR - filled, "",
            floor(100.0 * done));
    if (isfinite(error))
        fprintf(stderr, ", error %.2g %%", 100.0 * error);
    double elapsed = now - progress->started_s;
    if (done > progress->before && elapsed > 0.3) {
        fputs(", ", stderr);
        put_time(elapsed * (1.0 - done) / (done - progress->before));
        fputs(" left", stderr);
    }
    fflush(stderr);
}

void pp_progress_end(struct pp_progress *progress)
{
    if (progress->shown)
        fputs("\r\033[K", stderr);
    progress->shown = false;
}
