/* bench_large_rooms.c - processor time of all methods, for one point and the average,
 * in rooms with hundreds or thousands of parts of one kind. */
#include <math.h>
#include <stdio.h>

#include "bench/bench.h"
#include "methods/evaluate.h"
#include "model/results/report.h"

/* Text of a room file under construction; must not be copied, since the stream refers
 * to it. */
struct text {
    char *bytes;
    size_t size;
    FILE *out;
};

static void begin_room(struct text *text)
{
    text->out = open_memstream(&text->bytes, &text->size);
    if (!text->out)
        exit(3);
    fputs("<room version='1'>", text->out);
}

static void add_box(FILE *out, double width_m)
{
    fprintf(out, "<plan width='%g' depth='9.3' height='2.7'/>", width_m);
}

/* A plan with corners at 10 m and at inner_m from its centre, alternating, and a
 * window. */
static void add_ring(FILE *out, int corners, double inner_m)
{
    fputs("<plan height='2.7'>", out);
    for (int i = 0; i < corners; i++) {
        double angle = 2.0 * PP_PI * (i + 0.5) / corners, r = i % 2 ? inner_m : 10.0;
        fprintf(out, "<vertex x='%.5f' y='%.5f'/>", r * cos(angle), r * sin(angle));
    }
    fputs("</plan><window wall='3' left='0.03' sill='0.8' width='0.1' height='1.5'/>",
          out);
}

static void add_blocks(FILE *out, int count)
{
    fputs("<window wall='south' left='0.35' sill='0.8' width='2.4' height='1.5'/>",
          out);
    int side = (int)ceil(sqrt(count));
    for (int i = 0; i < count; i++)
        fprintf(out,
                "<block x='%.2f' y='%.2f' width='0.5' depth='0.5' height='%.3f' "
                "rotate='%d'/>",
                -10.0 + i % side * 0.93, -6.0 - i / side * 0.97,
                1.0 + i * 37 % 101 / 40.0, i * 13 % 90);
}

static void time_room(const char *name, struct text *text)
{
    fputs("<point x='1.1' y='0.7'/></room>", text->out);
    fclose(text->out);
    struct pp_error err = {0};
    double start = processor_s();
    struct pp_outside_light light;
    struct pp_world *world = world_of(&light, text->bytes);
    struct pp_receiver receiver = {
        {1.1, 0.7, world->working_plane_m}, {0, 0, 1}, 0, 0.0};
    struct pp_report report = {
        .world = world, .light = light, .receivers = &receiver, .receiver_count = 1};
    must(pp_methods_evaluate(&report, "all", &err), &err);
    printf("%-31s %8.2f s\n", name, processor_s() - start);
    pp_report_clear(&report);
    pp_world_destroy(world);
    free(text->bytes);
}

int main(void)
{
    struct text text;
    begin_room(&text);
    add_box(text.out, 3.1);
    add_blocks(text.out, 500);
    time_room("500 blocks outside a window", &text);

    begin_room(&text);
    add_box(text.out, 3.1);
    add_blocks(text.out, 5000);
    time_room("5,000 blocks outside a window", &text);

    begin_room(&text);
    add_ring(text.out, 500, 7.0);
    time_room("a star of 500 corners", &text);

    begin_room(&text);
    add_ring(text.out, 300, 10.0);
    for (int wall = 1; wall <= 300; wall++)
        fprintf(text.out, "<skyline wall='%d' angle='%d'/>", wall, 10 + wall * 7 % 50);
    time_room("300 walls with a skyline each", &text);

    begin_room(&text);
    add_box(text.out, 51.0);
    for (int i = 0; i < 1000; i++)
        fprintf(text.out,
                "<window wall='south' left='%.3f' sill='0.9' width='0.03' "
                "height='1.3'/>",
                0.02 + 0.05 * i);
    time_room("1,000 windows", &text);
    return 0;
}
