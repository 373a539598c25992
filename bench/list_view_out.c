/* list_view_out.c - prints the view out (studies/view_out.h) of a room from one eye, for
 * compare_view_out.sh.
 *
 *     list_view_out FILE X Y Z [LINES]
 *
 * LINES: lines of sight through each opening.
 *
 * Prints the sight angle in degrees, the distance in metres (inf: unlimited), the sum of
 * the layers through all openings (sky 1, landscape 2, ground 4), and the number of
 * layers through one opening.
 */
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "model/base/read_file.h"
#include "simulate/scene/light_scene_of_world.h"
#include "studies/view_out.h"

int main(int argc, char **argv)
{
    enum { MOST = 1 << 20 };
    struct pp_error err = {.message = "the room has mistakes"};
    struct pp_outside_light light;
    struct pp_light_scene *scene;
    struct pp_view_out view;
    char *bytes;
    size_t length;
    if (argc != 5 && argc != 6) {
        fprintf(stderr, "usage: list_view_out FILE X Y Z [LINES]\n");
        return 2;
    }
    must(pp_read_file(&bytes, &length, argv[1], MOST, &err), &err);
    struct pp_world *world = world_of(&light, bytes);
    must(pp_light_scene_of_world_matt(&scene, world, &err), &err);
    struct pp_vec3 eye = pp_vec(atof(argv[2]), atof(argv[3]), atof(argv[4]));
    int lines = argc == 6 ? atoi(argv[5]) : PP_VIEW_OUT_LINES;
    must(pp_view_out_from(&view, world, scene, eye, lines, &err), &err);
    printf("%.4f %.4f %d %d\n", view.sight_angle_rad / PP_RAD, view.distance_m,
           view.layers, view.layers_together);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
    free(bytes);
    return 0;
}
