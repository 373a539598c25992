/* fuzz_rad.c - whatever bytes a Radiance scene holds, reading it ends well, and what
 * was read can be written and read back.
 *
 * For clang's libFuzzer (make fuzz). The sanitizers say what is wrong; besides, a scene
 * is refused with a reason that has file and line, or taken; then its shapes name
 * materials that there are, and as many come back.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/rad_read.h"
#include "model/rad_write.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length);

static void must(bool holds)
{
    if (!holds)
        abort();
}

static void write_and_read(const struct pp_scene_description *scene)
{
    struct pp_error err = {PP_OK, ""};
    struct pp_rad_writer *writer;
    if (pp_rad_writer_create(&writer, scene, &err) != PP_OK) {
        must(err.message[0] != '\0');
        return;
    }
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    must(out != NULL);
    pp_rad_write_materials(writer, out);
    pp_rad_write_shapes(writer, "s", 0, scene->shape_count, out);
    fclose(out);
    pp_rad_writer_destroy(writer);
    struct pp_scene_description back;
    struct pp_rad_summary summary;
    enum pp_status status =
        pp_rad_parse(&back, &summary, text, length, "back.rad", &err);
    must(status == PP_OK || err.message[0] != '\0');
    if (status == PP_OK)
        must(back.shape_count + summary.flat >= scene->shape_count);
    pp_scene_description_clear(&back);
    free(text);
}

/* Lines that read further files are left out: they would leave the fuzzer's bytes. */
static bool reads_files(const uint8_t *bytes, size_t length)
{
    return memmem(bytes, length, "xform", 5) != NULL;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    struct pp_error err = {PP_OK, ""};
    struct pp_scene_description scene;
    struct pp_rad_summary summary;
    if (reads_files(bytes, length))
        return 0;
    enum pp_status status =
        pp_rad_parse(&scene, &summary, (const char *)bytes, length, "fuzz.rad", &err);
    must(status == PP_OK || err.message[0] != '\0');
    must(status != PP_BAD_INPUT || strncmp(err.message, "fuzz.rad:", 9) == 0);
    for (int i = 0; i < scene.shape_count; i++)
        must(scene.shapes[i].material >= 0
             && scene.shapes[i].material < scene.material_count
             && scene.shapes[i].back_material < scene.material_count);
    if (status == PP_OK)
        write_and_read(&scene);
    pp_scene_description_clear(&scene);
    return 0;
}
