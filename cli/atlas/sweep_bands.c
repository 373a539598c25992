/* sweep_bands.c - the bands of an atlas as jobs of the command line. */
#include "cli/atlas/sweep_bands.h"

#include "cli/job.h"
#include "cli/message.h"
#include "reports/atlas/atlas_bands_csv.h"
#include "reports/atlas/atlas_bands_text.h"
#include "reports/atlas/band_pages.h"

struct bands_run {
    const char *path;
    bool table; /* as the table, not as a trial */
    struct pp_atlas_bands bands;
};

static enum pp_status compute_sweep_bands(void *data, struct pp_error *err)
{
    struct bands_run *run = data;
    struct pp_atlas_table table;
    enum pp_status status = pp_atlas_table_read(&table, run->path, err);
    if (status == PP_OK)
        status = pp_atlas_bands_fit(&run->bands, &table, err);
    if (status == PP_OK && run->bands.column_count == 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s: %d rooms; expected enough for bands, %d of a method",
                         run->path, run->bands.rooms, pp_band_tree_rules.rooms_least);
    pp_atlas_table_clear(&table);
    return status;
}

static enum pp_status print_sweep_bands(const void *data, FILE *out,
                                        struct pp_error *err)
{
    const struct bands_run *run = data;
    (void)err;
    if (run->table)
        pp_atlas_bands_csv(&run->bands, out);
    else
        pp_atlas_bands_text(&run->bands, out);
    return PP_OK;
}

enum pp_exit pp_sweep_bands(const char *path, const char *output)
{
    struct bands_run run = {.path = path, .table = true};
    enum pp_exit result = pp_job_run(
        &(struct pp_job){output, compute_sweep_bands, print_sweep_bands, NULL, &run});
    pp_atlas_bands_clear(&run.bands);
    return result;
}

enum pp_exit pp_sweep_bands_try(const char *path, const char *output)
{
    struct bands_run run = {.path = path};
    enum pp_exit result = pp_job_run(
        &(struct pp_job){output, compute_sweep_bands, print_sweep_bands, NULL, &run});
    int outside = pp_atlas_bands_outside(&run.bands);
    if (result == PP_EXIT_DONE && outside > 0) {
        pp_message("%d regimes are farther from 95 %% than chance has it", outside);
        result = PP_EXIT_INPUT;
    }
    pp_atlas_bands_clear(&run.bands);
    return result;
}

/* ---- what is compiled in ---- */

static enum pp_status compute_nothing(void *data, struct pp_error *err)
{
    (void)data, (void)err;
    return PP_OK;
}

static enum pp_status print_pages(const void *data, FILE *out, struct pp_error *err)
{
    (void)data, (void)err;
    pp_band_pages(out);
    return PP_OK;
}

enum pp_exit pp_sweep_bands_accuracy(const char *output)
{
    return pp_job_run(
        &(struct pp_job){output, compute_nothing, print_pages, NULL, NULL});
}
