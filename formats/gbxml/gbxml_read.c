/* gbxml_read.c - the elements of gbXML, one by one. */
#include "formats/gbxml/gbxml_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "formats/gbxml/gbxml_loop.h"
#include "model/base/array.h"

/* Maximum number of surfaces and of spaces in a file. */
enum { SURFACES_MOST = 100000, SPACES_MOST = 10000 };

struct gbxml_named;

struct gbxml_reader {
    struct pp_gbxml_model *model;
    const struct pp_xml_element *root;
    struct pp_gbxml_loop_reader loops;
    double square_metre, cubic_metre; /* factors for the file's units; NAN: unknown
                                       * unit */
    struct gbxml_named *named;
    int named_count;
    int between, without_type; /* numbers of openings between spaces, and of openings
                                * without a window type */
    int air;                   /* number of air surfaces between spaces */
    const char *file;
    struct pp_mistakes *notes;
    struct pp_error *err;
};

/* A unit of length: its name, with which the names of area and volume units end, and
 * its length (m). */
struct gbxml_unit {
    const char *name;
    double metre;
};

static const struct gbxml_unit lengths[] = {
    {"Kilometers", 1e3},   {"Meters", 1.0},     {"Centimeters", 0.01},
    {"Millimeters", 1e-3}, {"Miles", 1609.344}, {"Yards", 0.9144},
    {"Feet", 0.3048},      {"Inches", 0.0254}};

/* Length (m) of the unit `typed` after its prefix ("Square"); NAN: not a unit. */
static double find_unit(const char *typed, const char *prefix)
{
    size_t length = strlen(prefix);
    if (!typed || strncmp(typed, prefix, length) != 0)
        return NAN;
    for (int i = 0; i < (int)(sizeof lengths / sizeof *lengths); i++)
        if (strcmp(typed + length, lengths[i].name) == 0)
            return lengths[i].metre;
    return NAN;
}

static enum pp_status read_units(struct gbxml_reader *r)
{
    const char *typed = pp_gbxml_document_attribute(r->root, "lengthUnit");
    r->loops.metre = find_unit(typed, "");
    r->square_metre =
        pow(find_unit(pp_gbxml_document_attribute(r->root, "areaUnit"), "Square"), 2.0);
    r->cubic_metre = pow(
        find_unit(pp_gbxml_document_attribute(r->root, "volumeUnit"), "Cubic"), 3.0);
    if (isfinite(r->loops.metre))
        return PP_OK;
    return pp_fail(r->err, PP_BAD_INPUT,
                   "%s:%d: lengthUnit is \"%.40s\"; expected Meters, Feet, "
                   "Millimeters, Inches or another length unit of gbXML",
                   r->file, r->root->line, typed ? typed : "");
}

/* ---- polygons ---- */

/* Reads the outline of an element; the outline is empty, with a note, if there is
 * none. */
static enum pp_status read_outline(struct gbxml_reader *r,
                                   const struct pp_xml_element *element,
                                   struct pp_gbxml_polygon *polygon)
{
    const char *id = pp_gbxml_document_attribute(element, "id");
    const struct pp_xml_element *loop =
        pp_gbxml_document_path(element, "PlanarGeometry/PolyLoop");
    *polygon = (struct pp_gbxml_polygon){0};
    if (loop)
        return pp_gbxml_loop_read(polygon, &r->loops, loop);
    pp_mistakes_add(r->notes, element->line,
                    "%s \"%.60s\" has no PlanarGeometry and is ignored", element->name,
                    id ? id : "");
    return PP_OK;
}

/* ---- light ---- */

/* A construction or window type with its id. */
struct gbxml_named {
    const char *name, *id;
    const struct pp_xml_element *element;
};

static int by_name(const void *a, const void *b)
{
    const struct gbxml_named *one = a, *other = b;
    int names = strcmp(one->name, other->name);
    return names ? names : strcmp(one->id, other->id);
}

/* Lists all constructions and window types, sorted. */
static enum pp_status list_named(struct gbxml_reader *r)
{
    static const char *const names[] = {"Construction", "WindowType"};
    for (int i = 0; i < 2; i++)
        for (const struct pp_xml_element *at =
                 pp_gbxml_document_child(r->root, names[i]);
             at; at = pp_gbxml_document_next(at, names[i])) {
            const char *id = pp_gbxml_document_attribute(at, "id");
            if (!id)
                continue;
            enum pp_status status =
                pp_array_append(&r->named, r->named_count, sizeof *r->named, r->err);
            if (status != PP_OK)
                return status;
            r->named[r->named_count++] = (struct gbxml_named){names[i], id, at};
        }
    if (r->named_count > 0)
        qsort(r->named, (size_t)r->named_count, sizeof *r->named, by_name);
    return PP_OK;
}

/* The element of that name and id; NULL: none. */
static const struct pp_xml_element *find_by_id(const struct gbxml_reader *r,
                                               const char *name, const char *id)
{
    const struct gbxml_named wanted = {name, id ? id : "", NULL};
    const struct gbxml_named *found =
        r->named_count > 0 ? bsearch(&wanted, r->named, (size_t)r->named_count,
                                     sizeof *r->named, by_name)
                           : NULL;
    return found ? found->element : NULL;
}

/* Returns the first value from 0 to 1 among the child elements of that name and type
 * ("IntVisible"); percentages are converted to fractions. NAN if there is none. */
static double read_share(const struct pp_xml_element *element, const char *name,
                         const char *type)
{
    for (const struct pp_xml_element *at = pp_gbxml_document_child(element, name); at;
         at = pp_gbxml_document_next(at, name)) {
        const char *of = pp_gbxml_document_attribute(at, "type");
        const char *unit = pp_gbxml_document_attribute(at, "unit");
        double share;
        if (!of || strcmp(of, type) != 0 || !pp_gbxml_document_number(at, &share))
            continue;
        if (unit && strcmp(unit, "Percent") == 0)
            share /= 100.0;
        if (share >= 0.0 && share <= 1.0)
            return share;
    }
    return NAN;
}

/* Window type of an opening, or its construction instead; NULL: none. */
static const struct pp_xml_element *find_window_type(
    const struct gbxml_reader *r, const struct pp_xml_element *opening)
{
    static const char *const refs[] = {"windowTypeIdRef", "constructionIdRef"};
    static const char *const names[] = {"WindowType", "Construction"};
    const struct pp_xml_element *found = NULL;
    for (int i = 0; i < 2 && !found; i++)
        found = find_by_id(r, names[i], pp_gbxml_document_attribute(opening, refs[i]));
    return found;
}

/* Visible transmittance of the type; NAN if it is not above 0, with a note, or if there
 * is no type (NULL), which is counted. */
static double take_transmittance(struct gbxml_reader *r,
                                 const struct pp_xml_element *type)
{
    double share = read_share(type, "Transmittance", "Visible");
    if (share > 0.0)
        return share;
    if (type)
        pp_mistakes_add(r->notes, type->line,
                        "%s \"%.60s\" has no visible transmittance above 0; its "
                        "openings get the glazing clear-double",
                        type->name, pp_gbxml_document_attribute(type, "id"));
    r->without_type += !type;
    return NAN;
}

/* ---- surfaces ---- */

static bool is_one_of(const char *word, const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(word, words[i]) == 0)
            return true;
    return false;
}

/* True if the opening transmits light. A hinged door counts only if its window type has
 * a transmittance. */
static bool lets_light_in(const char *opening_type, const struct pp_xml_element *type)
{
    static const char *const glazed[] = {"FixedWindow",
                                         "OperableWindow",
                                         "FixedSkylight",
                                         "OperableSkylight",
                                         "SlidingDoor",
                                         "Air",
                                         NULL};
    return is_one_of(opening_type, glazed)
           || (strcmp(opening_type, "NonSlidingDoor") == 0
               && read_share(type, "Transmittance", "Visible") > 0.0);
}

static enum pp_status add_gbxml_opening(struct gbxml_reader *r,
                                        struct pp_gbxml_surface *surface,
                                        const struct pp_xml_element *element)
{
    const char *kind = pp_gbxml_document_attribute(element, "openingType");
    const char *id = pp_gbxml_document_attribute(element, "id");
    const struct pp_xml_element *type = find_window_type(r, element);
    kind = kind ? kind : "";
    if (surface->spaces[1] && strcmp(surface->spaces[0], surface->spaces[1]) != 0) {
        r->between++;
        return PP_OK;
    }
    if (!lets_light_in(kind, type)) {
        pp_mistakes_add(
            r->notes, element->line,
            "opening \"%.60s\" of type \"%.40s\" is not a window, a skylight, or a "
            "sliding or glazed door; it is treated as part of the wall",
            id ? id : "", kind);
        return PP_OK;
    }
    struct pp_gbxml_opening opening = {.line = element->line, .name = id};
    enum pp_status status = read_outline(r, element, &opening.outline);
    if (status != PP_OK || opening.outline.count == 0)
        return status;
    opening.is_air = strcmp(kind, "Air") == 0;
    opening.transmittance = opening.is_air ? 1.0 : take_transmittance(r, type);
    status = pp_array_append(&surface->openings, surface->opening_count,
                             sizeof *surface->openings, r->err);
    if (status == PP_OK)
        surface->openings[surface->opening_count++] = opening;
    else
        free(opening.outline.corners);
    return status;
}

static enum pp_status add_gbxml_surface(struct gbxml_reader *r,
                                        const struct pp_xml_element *element)
{
    struct pp_gbxml_model *model = r->model;
    const char *type = pp_gbxml_document_attribute(element, "surfaceType");
    struct pp_gbxml_surface surface = {.line = element->line, .type = type ? type : ""};
    if (model->surface_count == SURFACES_MOST)
        return pp_fail(r->err, PP_BAD_INPUT,
                       "%s:%d: there are more than %d surfaces; expected fewer",
                       r->file, surface.line, SURFACES_MOST);
    enum pp_status status = read_outline(r, element, &surface.outline);
    if (status != PP_OK || surface.outline.count == 0)
        return status;
    int neighbours = 0;
    for (const struct pp_xml_element *at =
             pp_gbxml_document_child(element, "AdjacentSpaceId");
         at && neighbours < PP_GBXML_NEIGHBOURS;
         at = pp_gbxml_document_next(at, "AdjacentSpaceId")) {
        const char *id = pp_gbxml_document_attribute(at, "spaceIdRef");
        if (id)
            surface.spaces[neighbours++] = id;
    }
    const struct pp_xml_element *construction = find_by_id(
        r, "Construction", pp_gbxml_document_attribute(element, "constructionIdRef"));
    surface.reflectance = read_share(construction, "Reflectance", "IntVisible");
    r->air += strcmp(surface.type, "Air") == 0 && surface.spaces[1];
    status = pp_array_append(&model->surfaces, model->surface_count,
                             sizeof *model->surfaces, r->err);
    if (status != PP_OK) {
        free(surface.outline.corners);
        return status;
    }
    struct pp_gbxml_surface *placed = &model->surfaces[model->surface_count++];
    *placed = surface;
    for (const struct pp_xml_element *at = pp_gbxml_document_child(element, "Opening");
         at && status == PP_OK; at = pp_gbxml_document_next(at, "Opening"))
        status = add_gbxml_opening(r, placed, at);
    return status;
}

/* ---- spaces ---- */

static enum pp_status add_shell(struct gbxml_reader *r, struct pp_gbxml_space *space,
                                const struct pp_xml_element *element)
{
    enum pp_status status = PP_OK;
    const struct pp_xml_element *shell =
        pp_gbxml_document_path(element, "ShellGeometry/ClosedShell");
    for (const struct pp_xml_element *loop = pp_gbxml_document_child(shell, "PolyLoop");
         loop && status == PP_OK; loop = pp_gbxml_document_next(loop, "PolyLoop")) {
        struct pp_gbxml_polygon polygon;
        status = pp_gbxml_loop_read(&polygon, &r->loops, loop);
        if (status != PP_OK || polygon.count == 0)
            continue;
        status = pp_array_append(&space->shell, space->shell_count,
                                 sizeof *space->shell, r->err);
        if (status == PP_OK)
            space->shell[space->shell_count++] = polygon;
        else
            free(polygon.corners);
    }
    return status;
}

/* Reads a size in the unit of the file; NAN if it is not given, or not above 0. */
static double read_space_size(const struct pp_xml_element *element, const char *name,
                              double unit)
{
    double value;
    if (!pp_gbxml_document_number(pp_gbxml_document_child(element, name), &value))
        return NAN;
    value *= unit;
    return value > 0.0 && isfinite(value) ? value : NAN;
}

static enum pp_status add_space(struct gbxml_reader *r,
                                const struct pp_xml_element *element)
{
    struct pp_gbxml_model *model = r->model;
    const char *id = pp_gbxml_document_attribute(element, "id");
    int line = element->line;
    if (!id) {
        pp_mistakes_add(r->notes, line, "a Space has no id and is ignored");
        return PP_OK;
    }
    if (model->space_count == SPACES_MOST)
        return pp_fail(r->err, PP_BAD_INPUT,
                       "%s:%d: there are more than %d spaces; expected fewer", r->file,
                       line, SPACES_MOST);
    enum pp_status status = pp_array_append(&model->spaces, model->space_count,
                                            sizeof *model->spaces, r->err);
    if (status != PP_OK)
        return status;
    struct pp_gbxml_space *space = &model->spaces[model->space_count++];
    const char *name = pp_gbxml_document_text(pp_gbxml_document_child(element, "Name"));
    *space = (struct pp_gbxml_space){
        .line = line,
        .id = id,
        .name = name && *name ? name : NULL,
        .type = pp_gbxml_document_attribute(element, "spaceType"),
        .area_m2 = read_space_size(element, "Area", r->square_metre),
        .volume_m3 = read_space_size(element, "Volume", r->cubic_metre)};
    const struct pp_xml_element *floor =
        pp_gbxml_document_path(element, "PlanarGeometry/PolyLoop");
    if (floor)
        status = pp_gbxml_loop_read(&space->floor, &r->loops, floor);
    return status == PP_OK ? add_shell(r, space, element) : status;
}

/* ---- the file ---- */

static void read_location(struct gbxml_reader *r, const struct pp_xml_element *campus)
{
    struct pp_gbxml_model *model = r->model;
    const struct pp_xml_element *location = pp_gbxml_document_child(campus, "Location");
    const struct pp_xml_element *azimuth =
        pp_gbxml_document_child(location, "CADModelAzimuth");
    double value;
    model->latitude = model->longitude = NAN;
    if (pp_gbxml_document_number(pp_gbxml_document_child(location, "Latitude"), &value)
        && fabs(value) <= 90.0)
        model->latitude = value;
    if (pp_gbxml_document_number(pp_gbxml_document_child(location, "Longitude"), &value)
        && fabs(value) <= 180.0)
        model->longitude = value;
    if (!azimuth || !pp_gbxml_document_number(azimuth, &value) || value == 0.0
        || !(fabs(value) <= 360.0))
        return;
    model->north_deg = value;
    pp_mistakes_add(
        r->notes, azimuth->line,
        "CADModelAzimuth %g is used as the bearing of the plan's +y, clockwise from "
        "north, as in the schema; some programs count in the other direction",
        value);
}

static enum pp_status read_campus(struct gbxml_reader *r,
                                  const struct pp_xml_element *campus)
{
    enum pp_status status = PP_OK;
    for (const struct pp_xml_element *building =
             pp_gbxml_document_child(campus, "Building");
         building; building = pp_gbxml_document_next(building, "Building")) {
        if (!r->model->name)
            r->model->name =
                pp_gbxml_document_text(pp_gbxml_document_child(building, "Name"));
        for (const struct pp_xml_element *space =
                 pp_gbxml_document_child(building, "Space");
             space && status == PP_OK; space = pp_gbxml_document_next(space, "Space"))
            status = add_space(r, space);
    }
    for (const struct pp_xml_element *surface =
             pp_gbxml_document_child(campus, "Surface");
         surface && status == PP_OK;
         surface = pp_gbxml_document_next(surface, "Surface"))
        status = add_gbxml_surface(r, surface);
    return status;
}

enum pp_status pp_gbxml_read(struct pp_gbxml_model *model,
                             const struct pp_xml *document, const char *file,
                             struct pp_mistakes *notes, struct pp_error *err)
{
    struct gbxml_reader r = {.model = model,
                             .root = document->root,
                             .file = file,
                             .notes = notes,
                             .err = err};
    *model = (struct pp_gbxml_model){.latitude = NAN, .longitude = NAN};
    r.loops.notes = notes;
    r.loops.err = err;
    enum pp_status status = pp_clipper_create(&r.loops.clipper, err);
    if (status == PP_OK)
        status = read_units(&r);
    const struct pp_xml_element *campus = pp_gbxml_document_child(r.root, "Campus");
    if (status == PP_OK && !campus)
        status = pp_fail(err, PP_BAD_INPUT, "%s: has no Campus", file);
    if (status == PP_OK) {
        read_location(&r, campus);
        pp_gbxml_loop_find_origin(&r.loops, campus);
    }
    if (status == PP_OK)
        status = list_named(&r);
    if (status == PP_OK)
        status = read_campus(&r, campus);
    free(r.named);
    pp_clipper_destroy(r.loops.clipper);
    if (r.air > 0)
        pp_mistakes_add(notes, 0, "%d air surfaces between spaces are treated as walls",
                        r.air);
    if (r.between > 0)
        pp_mistakes_add(notes, 0, "%d openings between spaces are treated as walls",
                        r.between);
    if (r.without_type > 0)
        pp_mistakes_add(
            notes, 0,
            "%d openings have no window type and get the glazing clear-double",
            r.without_type);
    if (status == PP_OK && model->space_count == 0)
        status = pp_fail(err, PP_BAD_INPUT, "%s: the Campus has no Space", file);
    return status;
}
