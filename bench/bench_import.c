/* bench_import.c - time and memory for reading a scene of a million polygons and
 * building its ray-tracing structure.
 *
 * Target: less than 10 s and 1 GiB for both steps together.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include "bench/bench.h"
#include "formats/radiance/read/rad_read.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/light_scene_of_description.h"

enum { ACROSS = 1000, RUNS = 3 };

static const char materials[] = "void plastic a 0 0 5 .5 .4 .3 0 0\n"
                                "void plastic b 0 0 5 .7 .7 .7 .02 .1\n"
                                "void glow c 0 0 4 1 1 1 0\n"
                                "c source sky 0 0 4 0 0 1 180\n";

/* Writes a million slanting tiles, each explicitly. */
static void write_tiles(FILE *out)
{
    fputs(materials, out);
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        double x = i % ACROSS + 0.3 * sin(0.7 * i), y = i / ACROSS + 0.3 * sin(1.1 * i);
        double z = 1.5 + 1.4 * sin(0.3 * i);
        fprintf(out,
                "%c polygon tile%d\n0\n0\n12\n\t%.6f %.6f %.6f\n\t%.6f %.6f %.6f\n"
                "\t%.6f %.6f %.6f\n\t%.6f %.6f %.6f\n",
                i % 2 ? 'a' : 'b', i, x, y, z, x + 0.8, y, z, x + 0.8, y + 0.7, z + 0.3,
                x, y + 0.7, z + 0.3);
    }
}

/* Writes a million polygons as boxes, which two array commands generate. */
static void write_boxes(FILE *out)
{
    fputs(materials, out);
    fputs("!genbox a box .8 .7 2 | xform -a 408 -t 1 0 0 -a 408 -t 0 1 0\n"
          "!genbox b box .3 .2 1 | xform -t 0 0 5 -a 202 -t 2 0 0\n",
          out);
}

static void bench(const char *name, void (*write_scene)(FILE *out))
{
    const char *place = getenv("TMPDIR");
    char path[4096];
    snprintf(path, sizeof path, "%s/bench_import-XXXXXX", place ? place : "/tmp");
    int file = mkstemp(path);
    FILE *out = file < 0 ? NULL : fdopen(file, "w");
    if (!out) {
        perror("bench_import");
        exit(3);
    }
    write_scene(out);
    double megabytes = 1e-6 * (double)ftell(out);
    fclose(out);

    double read = INFINITY, built = INFINITY;
    long polygons = 0;
    for (int run = 0; run < RUNS; run++) {
        struct pp_scene_description description;
        struct pp_rad_summary summary;
        struct pp_light_scene *scene;
        struct pp_error err = {0};
        const char *const paths[] = {path};
        double start = processor_s();
        must(pp_rad_read(&description, &summary, paths, 1, &err), &err);
        double middle = processor_s();
        must(pp_light_scene_of_description(&scene, &description, &err), &err);
        read = fmin(read, middle - start);
        built = fmin(built, processor_s() - middle);
        polygons = summary.polygons;
        pp_light_scene_destroy(scene);
        pp_scene_description_clear(&description);
    }
    unlink(path);
    printf("%s: %ld polygons of %.1f MB: read in %.2f s, built in %.2f s of one core "
           "(best of %d)\n",
           name, polygons, megabytes, read, built, (int)RUNS);
    printf("  together %.1f s (target: 10 s)\n", read + built);
}

int main(void)
{
    bench("tiles", write_tiles);
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    printf("  peak memory %.0f MiB (target: 1024 MiB)\n",
           (double)usage.ru_maxrss / 1024.0);
    bench("boxes by arrays", write_boxes);
    return 0;
}
