/* annual_stores.c - see annual_stores.h. */
#include "cli/annual/annual_stores.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "cli/atlas/locked_file.h"
#include "simulate/year/year_store.h"

#define PLACE(member) offsetof(struct pp_annual_stores, member)

const struct pp_option pp_annual_stores_options[] = {
    {"coefficients", 0, "FILE",
     "Also write the daylight coefficients of the ground and of all sky patches, as a "
     "matrix for Radiance (dctimestep); and all randomisations, in "
     "FILE.randomisations, "
     "for --coefficients-from.",
     pp_options_read_output, PLACE(matrix)},
    {"coefficients-from", 0, "FILE",
     "Use stored coefficients of the room, by --coefficients or --checkpoint, instead "
     "of "
     "light paths. Weather, hours and targets may be others than for the stored run.",
     pp_options_read_input, PLACE(from)},
    {"checkpoint", 0, "FILE",
     "Save finished work in FILE; the same command continues from there.",
     pp_options_read_updated, PLACE(checkpoint)},
    {0},
};

enum pp_status pp_annual_stores_check(const struct pp_annual_stores *stores,
                                      bool has_error, bool exact_sky,
                                      struct pp_error *err)
{
    const char *given = stores->matrix       ? "--coefficients"
                        : stores->from       ? "--coefficients-from"
                        : stores->checkpoint ? "--checkpoint"
                                             : NULL;
    if (given && exact_sky)
        return pp_fail(err, PP_BAD_INPUT, "--exact-sky cannot be combined with %s",
                       given);
    if (stores->from && has_error)
        return pp_fail(err, PP_BAD_INPUT,
                       "--error does not apply, because the stored coefficients have "
                       "a fixed number of light paths");
    return PP_OK;
}

/* The name of the file of randomisations that belongs to a matrix; NULL if out of
 * memory. */
static char *beside(const char *matrix)
{
    static const char end[] = ".randomisations";
    size_t length = strlen(matrix);
    char *path = malloc(length + sizeof end);
    if (path) {
        memcpy(path, matrix, length);
        memcpy(path + length, end, sizeof end);
    }
    return path;
}

static bool is_matrix(FILE *file)
{
    static const char start[] = "#?RADIANCE";
    char first[sizeof start] = "";
    size_t got = fread(first, 1, sizeof start - 1, file);
    rewind(file);
    return got == sizeof start - 1 && strcmp(first, start) == 0;
}

static enum pp_status open_from(struct pp_annual_stores *stores, struct pp_error *err)
{
    const char *path = stores->from;
    stores->from_file = fopen(path, "rbe");
    if (stores->from_file && is_matrix(stores->from_file)) {
        fclose(stores->from_file);
        stores->from_file = NULL;
        path = stores->from_path = beside(stores->from);
        if (!path)
            return pp_fail_memory(err);
        stores->from_file = fopen(path, "rbe");
    }
    if (!stores->from_file)
        return pp_fail(err, PP_BAD_INPUT, "%s cannot be read: %s", path,
                       strerror(errno));
    return pp_year_store_create(&stores->list[stores->count++], stores->from_file, path,
                                PP_YEAR_STORE_READ, err);
}

static enum pp_status open_into(struct pp_annual_stores *stores, struct pp_error *err)
{
    stores->into_path = beside(stores->matrix);
    if (!stores->into_path)
        return pp_fail_memory(err);
    enum pp_status status = pp_output_open(&stores->into, stores->into_path, err);
    if (status != PP_OK)
        return status;
    stores->into_is_open = true;
    return pp_year_store_create(&stores->list[stores->count++], stores->into.stream,
                                stores->into_path, PP_YEAR_STORE_WRITE, err);
}

enum pp_status pp_annual_stores_open(struct pp_annual_stores *stores,
                                     struct pp_annual_options *options,
                                     struct pp_error *err)
{
    enum pp_status status = stores->from ? open_from(stores, err) : PP_OK;
    if (status == PP_OK && stores->checkpoint) {
        status = pp_locked_file_open(&stores->checkpoint_file, stores->checkpoint, err);
        if (status == PP_OK)
            status = pp_year_store_create(&stores->list[stores->count++],
                                          stores->checkpoint_file, stores->checkpoint,
                                          PP_YEAR_STORE_UPDATE, err);
    }
    if (status == PP_OK && stores->matrix && strcmp(stores->matrix, "-") != 0)
        status = open_into(stores, err);
    memcpy(options->stores, stores->list, sizeof options->stores);
    options->store_count = status == PP_OK ? stores->count : 0;
    return status;
}

enum pp_status pp_annual_stores_close(struct pp_annual_stores *stores, bool keep,
                                      struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < stores->count; i++)
        pp_year_store_destroy(stores->list[i]);
    stores->count = 0;
    if (stores->into_is_open && keep)
        status = pp_output_commit(&stores->into, err);
    if (stores->into_is_open)
        pp_output_clear(&stores->into);
    if (stores->from_file)
        fclose(stores->from_file);
    if (stores->checkpoint_file && fclose(stores->checkpoint_file) != 0
        && status == PP_OK)
        status = pp_fail(err, PP_SYSTEM, "%s cannot be written: %s", stores->checkpoint,
                         strerror(errno));
    free(stores->from_path);
    free(stores->into_path);
    stores->from_path = stores->into_path = NULL;
    stores->from_file = stores->checkpoint_file = NULL;
    stores->into_is_open = false;
    return status;
}
