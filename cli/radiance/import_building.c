/* import_building.c - reads and imports the file, and prints the room file and
 * notes. */
#include "cli/radiance/import_building.h"

#include <stdlib.h>
#include <string.h>

#include "cli/job.h"
#include "cli/message.h"
#include "formats/gbxml/gbxml_import.h"
#include "model/base/read_file.h"

enum { BYTES_MOST = 64 << 20 };

struct building_import {
    const char *file;
    struct pp_mistakes notes;
    char *xml;
    size_t length;
};

bool pp_import_building_is(const char *file)
{
    char bytes[512];
    FILE *in = strcmp(file, "-") == 0 ? NULL : fopen(file, "rb");
    if (!in)
        return false;
    size_t length = fread(bytes, 1, sizeof bytes, in);
    fclose(in);
    return pp_gbxml_import_is_xml(bytes, length);
}

static enum pp_status compute_imported_building(void *data, struct pp_error *err)
{
    struct building_import *import = data;
    char *bytes;
    size_t length;
    enum pp_status status =
        pp_read_file(&bytes, &length, import->file, BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    status = pp_gbxml_import(&import->xml, &import->length, bytes, length, import->file,
                             &import->notes, err);
    free(bytes);
    return status;
}

static enum pp_status print_imported_building(const void *data, FILE *out,
                                              struct pp_error *err)
{
    const struct building_import *import = data;
    if (fwrite(import->xml, 1, import->length, out) == import->length)
        return PP_OK;
    return pp_fail(err, PP_SYSTEM, "the room file could not be written");
}

static void print_notes(const struct pp_mistakes *notes)
{
    for (int i = 0; i < notes->count; i++)
        if (notes->list[i].line > 0)
            pp_message("%s:%d: %s", notes->file, notes->list[i].line,
                       notes->list[i].text);
        else
            pp_message("%s: %s", notes->file, notes->list[i].text);
    if (notes->truncated)
        pp_message("%s: there are more messages than can be shown", notes->file);
}

enum pp_exit pp_import_building_run(const char *file, const char *output, bool quiet)
{
    struct building_import import = {.file = file};
    pp_mistakes_init(&import.notes, file);
    enum pp_exit exit_status = pp_job_run(&(struct pp_job){
        output, compute_imported_building, print_imported_building, NULL, &import});
    if (!quiet)
        print_notes(&import.notes);
    pp_mistakes_clear(&import.notes);
    free(import.xml);
    return exit_status;
}
