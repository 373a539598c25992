/* doctor_places.c - finds the folders of this installation. Folders relative to the
 * program are searched first, then the folder set by configure. This order also works
 * for staged and moved trees, and for a build in the source tree. */
#include "cli/doctor/doctor_places.h"

#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

#include "cli/program/program_place.h"
#include "cli/ranks/mpirun.h"
#include "reports/parts/print.h"

enum { LABEL_WIDTH = 15, TEXT_WIDTH = 80 };

void pp_doctor_places_line(const char *label, const char *text, FILE *out)
{
    fprintf(out, "  %-*s", LABEL_WIDTH, label);
    pp_print_wrapped(text, 2 + LABEL_WIDTH, 2 + LABEL_WIDTH, TEXT_WIDTH, out);
}

/* Prints a path without wrapping it, so that it can be copied. */
static void print_path(const char *label, const char *path, FILE *out)
{
    fprintf(out, "  %-*s%s\n", LABEL_WIDTH, label, path);
}

/* Finds folder/file. Writes the path of the folder without "..". */
static bool find_file(const char *folder, const char *file, char *found)
{
    char path[2 * PATH_MAX];
    snprintf(path, sizeof path, "%s%s", folder, file);
    if (access(path, R_OK) != 0)
        return false;
    if (!realpath(folder, found))
        snprintf(found, PATH_MAX, "%s", folder);
    return true;
}

/* Searches for a file in folders relative to the program's folder, then in
 * `configured`. Prints the folder that contains the file; if there is none, prints
 * `instead`. */
static void print_folder(const char *label, const char *file, const char *configured,
                         const char *instead, FILE *out)
{
    static const char *const relative[] = {"../share/doc/pepperpot/",
                                           "../share/pepperpot/", "../", ""};
    char own[PATH_MAX], folder[PATH_MAX + 64], found[PATH_MAX];
    pp_program_place_own(own, sizeof own);
    bool there = false;
    for (int i = 0; i < 4 && own[0] && !there; i++) {
        snprintf(folder, sizeof folder, "%s%s", own, relative[i]);
        there = find_file(folder, file, found);
    }
    there = there || find_file(configured, file, found);
    if (!there) {
        pp_doctor_places_line(label, instead, out);
        return;
    }
    const char *slash = file;
    for (const char *at = file; *at; at++)
        if (*at == '/')
            slash = at;
    snprintf(folder, sizeof folder, "%s/%.*s", found, (int)(slash - file), file);
    print_path(label, folder, out);
}

void pp_doctor_places_print(FILE *out)
{
    char path[PATH_MAX + 64];
    pp_program_place_own(path, sizeof path);
    print_path("program", path[0] ? path : "unknown", out);
    print_folder("manual", "docs/index.md", PP_DOC_FOLDER "/", "not found", out);
    print_folder("manual, HTML", "html/index.html", PP_DOC_FOLDER "/",
                 "not found; to build it with Sphinx, run make docs", out);
    print_folder("examples", "examples/office.xml", PP_DOC_FOLDER "/", "not found",
                 out);
    print_folder("tables", "tables/finishes.csv", PP_DOC_FOLDER "/",
                 "compiled in; no files are needed", out);
    print_folder("schema", "room.rng", PP_DATA_FOLDER "/", "not found", out);
    if (pp_mpirun_module_path(path, sizeof path))
        print_path("MPI module", path, out);
    else
        pp_doctor_places_line(
            "MPI module", "not installed; to build it, configure with --with-mpi", out);
}

void pp_doctor_places_print_radiance(FILE *out)
{
    static const char *const programs[] = {"oconv", "rtrace"};
    for (int i = 0; i < 2; i++) {
        char path[PATH_MAX];
        bool there = pp_program_place_on_path(programs[i], path, sizeof path);
        print_path(programs[i], there ? path : "not on PATH", out);
    }
}
