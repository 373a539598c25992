/* read_mesh.c - see read_mesh.h. */
#include "model/room/read/read_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/mesh/mesh_file.h"

/* The file's path seen from where we are; to be freed, NULL: no memory. */
static char *path_of(const char *folder, const char *file)
{
    const char *before = file[0] == '/' ? "" : folder;
    char *path = malloc(strlen(before) + strlen(file) + 1);
    if (path)
        strcat(strcpy(path, before), file);
    return path;
}

/* The file's triangles, NULL where there is a mistake. */
static struct pp_shared_mesh *read_file(struct pp_reader *r, const char *file, int line)
{
    if (!r->folder) {
        pp_mistakes_add(r->mistakes, line,
                        "mesh: the room is in memory and has no folder to look for its "
                        "file in; expected a room that is read from a file");
        return NULL;
    }
    struct pp_shared_mesh *shared = calloc(1, sizeof *shared);
    char *path = path_of(r->folder, file);
    struct pp_error fault = {0};
    enum pp_status status =
        shared && path ? pp_mesh_file_read(&shared->mesh, path, &fault) : PP_SYSTEM;
    free(path);
    if (status == PP_OK) {
        shared->holders = 1;
        return shared;
    }
    if (shared)
        pp_mesh_triangles_clear(&shared->mesh);
    free(shared);
    if (fault.message[0])
        pp_mistakes_add(r->mistakes, line, "mesh: %s", fault.message);
    else
        r->out_of_memory = true;
    return NULL;
}

void pp_read_mesh(struct pp_reader *r, struct pp_room *room,
                  const struct pp_xml_element *e)
{
    struct pp_mesh_form form;
    if (!pp_reader_fill_form(r, &form, &pp_rule_mesh, e))
        return;
    struct pp_shared_mesh *file = read_file(r, form.file, e->line);
    if (!file || !PP_READER_RESERVE(r, room->meshes, room->mesh_count)) {
        r->bad_elements++;
        return;
    }
    double unit_m = file->mesh.unit_m > 0.0 ? file->mesh.unit_m : 1.0;
    room->meshes[room->mesh_count++] =
        (struct pp_mesh_part){.file = file,
                              .path = pp_reader_copy_text(r, form.file),
                              .name = pp_reader_copy_text(r, form.name),
                              .corner = pp_vec(form.x, form.y, form.z),
                              .scale = isnan(form.scale) ? unit_m : form.scale,
                              .rotate_rad = form.rotate_rad,
                              .y_is_up = form.up == 1,
                              .reflectance = form.finish.reflectance,
                              .finish = form.finish.finish,
                              .state = (enum pp_site_state)form.state,
                              .line = e->line};
}
