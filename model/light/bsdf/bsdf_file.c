/* bsdf_file.c - see bsdf_file.h. */
#include "model/light/bsdf/bsdf_file.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/base/xml.h"
#include "model/light/bsdf/number_list.h"
#include "model/light/bsdf/tensor_tree.h"

static const struct pp_xml_format window_format = {
    .file = "WINDOW file",
    .roots = "a <WindowElement>",
    .bytes_most = PP_BSDF_FILE_BYTES_MOST,
    .depth_most = PP_XML_DEPTH_MOST,
    .elements_most = 200000,
};

/* Names of the blocks, by enum pp_bsdf_part. */
static const char *const directions[PP_BSDF_PARTS] = {
    "Transmission Front", "Transmission Back", "Reflection Front", "Reflection Back"};

/* Layouts of the data; the value of a tree is its rank. */
enum layout { BY_COLUMNS, BY_ROWS, BY_TREE_3 = 3, BY_TREE_4 = 4 };

struct bsdf_reader {
    struct pp_bsdf *bsdf;
    const char *file;
    const struct pp_xml_element *definition; /* DataDefinition */
    enum layout layout;
    struct pp_error *err;
};

static const struct pp_xml_element *first_named(const struct pp_xml_element *e,
                                                const char *name)
{
    while (e && strcmp(e->name, name) != 0)
        e = e->next;
    return e;
}

static const struct pp_xml_element *child_of(const struct pp_xml_element *parent,
                                             const char *name)
{
    return parent ? first_named(parent->child, name) : NULL;
}

/* Text of a child; "" if there is none. */
static const char *text_of(const struct pp_xml_element *parent, const char *name)
{
    const struct pp_xml_element *e = child_of(parent, name);
    return e && e->text ? e->text : "";
}

static enum pp_status refuse(const struct bsdf_reader *r,
                             const struct pp_xml_element *at, const char *what)
{
    return pp_fail(r->err, PP_BAD_INPUT, "%.200s:%d: %s", r->file, at->line, what);
}

/* ---- bases ---- */

static bool number_of(const struct pp_xml_element *parent, const char *name,
                      double *value)
{
    return pp_text_parse_number(text_of(parent, name), value);
}

/* Reads the rings of a basis that the file defines. */
static bool read_rings(struct pp_angle_basis *basis,
                       const struct pp_xml_element *defined)
{
    *basis = (struct pp_angle_basis){.count = 0};
    for (const struct pp_xml_element *ring = child_of(defined, "AngleBasisBlock"); ring;
         ring = first_named(ring->next, "AngleBasisBlock")) {
        const struct pp_xml_element *bounds = child_of(ring, "ThetaBounds");
        double low, high, patches;
        if (!number_of(bounds, "LowerTheta", &low)
            || !number_of(bounds, "UpperTheta", &high)
            || !number_of(ring, "nPhis", &patches) || !(patches >= 1.0)
            || !(patches <= PP_ANGLE_BASIS_PATCHES_MOST)
            || !pp_angle_basis_add_ring(basis, low * PP_RAD, high * PP_RAD,
                                        (int)patches))
            return false;
    }
    return basis->ring_count > 0
           && basis->rings[basis->ring_count - 1].high_rad > 89.9 * PP_RAD;
}

static enum pp_status find_basis(const struct bsdf_reader *r,
                                 const struct pp_xml_element *block, const char *which,
                                 struct pp_angle_basis *basis)
{
    char shown[64];
    const char *name = text_of(block, which);
    for (const struct pp_xml_element *defined = child_of(r->definition, "AngleBasis");
         defined; defined = first_named(defined->next, "AngleBasis"))
        if (strcmp(text_of(defined, "AngleBasisName"), name) == 0)
            return read_rings(basis, defined)
                       ? PP_OK
                       : refuse(
                           r, defined,
                           "the rings of the angle basis are not valid; "
                           "expected AngleBasisBlocks whose ThetaBounds follow "
                           "each other from 0 to 90, with at most 1024 patches. nPhis "
                           "must be 1 or even, as every patch needs an opposite one");
    if (pp_angle_basis_named(basis, name))
        return PP_OK;
    return pp_fail(r->err, PP_BAD_INPUT,
                   "%.200s:%d: the %s is \"%s\"; expected \"LBNL/Klems Full\", "
                   "\"LBNL/Klems Half\", \"LBNL/Klems Quarter\", or a basis that the "
                   "file defines",
                   r->file, block->line, which,
                   pp_text_excerpt(shown, sizeof shown, name));
}

/* ---- blocks ---- */

static enum pp_status read_matrix(const struct bsdf_reader *r,
                                  const struct pp_xml_element *block,
                                  struct pp_bsdf_block *to)
{
    bool rows = r->layout == BY_ROWS;
    const struct pp_xml_element *data = child_of(block, "ScatteringData");
    enum pp_status status =
        find_basis(r, block, rows ? "RowAngleBasis" : "ColumnAngleBasis", &to->in);
    if (status == PP_OK)
        status =
            find_basis(r, block, rows ? "ColumnAngleBasis" : "RowAngleBasis", &to->out);
    if (status != PP_OK)
        return status;
    int count = to->in.count * to->out.count;
    struct pp_number_list numbers = {.count = 0};
    const char *text = data && data->text ? data->text : "";
    bool good = pp_number_list_read(&numbers, &text, count) && *text == '\0';
    if (good && numbers.count == count)
        status = pp_bsdf_block_init(to, r->err);
    else if (numbers.out_of_memory)
        status = pp_fail_memory(r->err);
    else
        status = pp_fail(r->err, PP_BAD_INPUT,
                         "%.200s:%d: ScatteringData has %d numbers%s; expected %d: one "
                         "for each of %d x %d pairs of directions",
                         r->file, data ? data->line : block->line, numbers.count,
                         good ? "" : " before other text or further numbers", count,
                         to->out.count, to->in.count);
    for (int i = 0; status == PP_OK && i < count; i++) {
        int at = rows ? i % to->out.count * to->in.count + i / to->out.count : i;
        to->values[at] = fmax(0.0, numbers.list[i]);
    }
    free(numbers.list);
    return status;
}

static enum pp_status read_tree_block(const struct bsdf_reader *r,
                                      const struct pp_xml_element *block,
                                      struct pp_bsdf_block *to)
{
    const struct pp_xml_element *data = child_of(block, "ScatteringData");
    const char *fault;
    enum pp_status status = pp_tensor_tree_read(
        to, data && data->text ? data->text : "", (int)r->layout, &fault, r->err);
    if (status == PP_OK && fault)
        status = pp_fail(r->err, PP_BAD_INPUT,
                         "%.200s:%d: ScatteringData is not a tensor tree: %s", r->file,
                         data ? data->line : block->line, fault);
    return status;
}

/* Reads a block of the visible band; blocks of unknown directions are skipped. */
static enum pp_status read_block(const struct bsdf_reader *r,
                                 const struct pp_xml_element *block)
{
    static const double MOST = 1e9; /* 1/sr */
    const char *direction = text_of(block, "WavelengthDataDirection");
    int part = 0;
    while (part < PP_BSDF_PARTS && strcmp(directions[part], direction) != 0)
        part++;
    if (part == PP_BSDF_PARTS || r->bsdf->blocks[part].values)
        return PP_OK;
    struct pp_bsdf_block *to = &r->bsdf->blocks[part];
    enum pp_status status = r->layout >= BY_TREE_3 ? read_tree_block(r, block, to)
                                                   : read_matrix(r, block, to);
    for (int i = 0; status == PP_OK && i < to->in.count * to->out.count; i++)
        if (!(to->values[i] <= MOST))
            return refuse(r, block, "a value is above 1e9; expected the BSDF in 1/sr");
    return status;
}

static bool is_visible(const struct pp_xml_element *data)
{
    return strcmp(text_of(data, "Wavelength"), "Visible") == 0;
}

static enum pp_status read_layer(struct bsdf_reader *r,
                                 const struct pp_xml_element *layer)
{
    enum pp_status status = PP_OK;
    for (const struct pp_xml_element *data = child_of(layer, "WavelengthData"); data;
         data = first_named(data->next, "WavelengthData")) {
        const struct pp_xml_element *block = child_of(data, "WavelengthDataBlock");
        while (block && is_visible(data)) {
            status = read_block(r, block);
            if (status != PP_OK)
                return status;
            block = first_named(block->next, "WavelengthDataBlock");
        }
    }
    const struct pp_bsdf_block *blocks = r->bsdf->blocks;
    if (!blocks[PP_BSDF_THROUGH_FRONT].values && !blocks[PP_BSDF_THROUGH_BACK].values)
        return refuse(r, layer,
                      "the file has no transmission for visible light; expected a "
                      "WavelengthDataBlock of \"Transmission Front\" or \"Transmission "
                      "Back\" in WavelengthData whose Wavelength is \"Visible\"");
    return pp_bsdf_complete(r->bsdf, r->err);
}

static enum pp_status find_layout(struct bsdf_reader *r,
                                  const struct pp_xml_element *layer)
{
    char shown[64];
    r->definition = child_of(layer, "DataDefinition");
    const char *layout = text_of(r->definition, "IncidentDataStructure");
    if (strcmp(layout, "Columns") == 0)
        r->layout = BY_COLUMNS;
    else if (strcmp(layout, "Rows") == 0)
        r->layout = BY_ROWS;
    else if (strcmp(layout, "TensorTree3") == 0)
        r->layout = BY_TREE_3;
    else if (strcmp(layout, "TensorTree4") == 0)
        r->layout = BY_TREE_4;
    else
        return pp_fail(r->err, PP_BAD_INPUT,
                       "%.200s:%d: IncidentDataStructure is \"%s\"; expected Columns, "
                       "Rows, TensorTree3 or TensorTree4",
                       r->file, layer->line,
                       pp_text_excerpt(shown, sizeof shown, layout));
    return PP_OK;
}

static enum pp_status read_root(struct bsdf_reader *r,
                                const struct pp_xml_element *root)
{
    char shown[64];
    if (strcmp(root->name, "WindowElement") != 0)
        return pp_fail(r->err, PP_BAD_INPUT,
                       "%.200s:%d: the outermost element is <%s>; expected "
                       "<WindowElement>, a WINDOW XML file",
                       r->file, root->line,
                       pp_text_excerpt(shown, sizeof shown, root->name));
    const struct pp_xml_element *layer = child_of(child_of(root, "Optical"), "Layer");
    if (!layer)
        return refuse(r, root, "there is no Layer in an element Optical; expected one");
    pp_text_excerpt(r->bsdf->name, sizeof r->bsdf->name,
                    text_of(child_of(layer, "Material"), "Name"));
    if (first_named(layer->next, "Layer"))
        pp_bsdf_warn(r->bsdf, "the file has several layers; only the first is used");
    enum pp_status status = find_layout(r, layer);
    return status == PP_OK ? read_layer(r, layer) : status;
}

/* Blanks a first line that is not XML, and the declaration after it: genBSDF begins its
 * output with such a line if its messages go to the same file. */
static void blank_message(char *bytes, size_t length)
{
    static const char MESSAGE[] = "Recover using:";
    if (length < sizeof MESSAGE || memcmp(bytes, MESSAGE, sizeof MESSAGE - 1) != 0)
        return;
    bool declares = false;
    for (size_t i = 0; i < length && (declares || bytes[i] != '<'); i++) {
        char c = bytes[i];
        if (c == '\n')
            declares = i + 2 < length && bytes[i + 1] == '<' && bytes[i + 2] == '?';
        else
            bytes[i] = ' ';
    }
}

enum pp_status pp_bsdf_file_parse(struct pp_bsdf *bsdf, char *bytes, size_t length,
                                  const char *name, struct pp_error *err)
{
    blank_message(bytes, length);
    struct pp_xml xml = {.root = NULL};
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, name);
    *bsdf = (struct pp_bsdf){.warning_count = 0};
    struct bsdf_reader r = {.bsdf = bsdf, .file = name, .err = err};
    enum pp_status status =
        pp_xml_parse(&xml, bytes, length, &window_format, &mistakes, err);
    bool parsed = status == PP_OK;
    if (parsed && mistakes.count > 0)
        status = pp_fail(err, PP_BAD_INPUT, "%.200s:%d: %s", name,
                         mistakes.list[0].line, mistakes.list[0].text);
    else if (parsed && (mistakes.truncated || !xml.root))
        status = pp_fail_memory(err);
    if (status == PP_OK)
        status = read_root(&r, xml.root);
    if (parsed)
        pp_xml_clear(&xml);
    pp_mistakes_clear(&mistakes);
    if (status != PP_OK)
        pp_bsdf_clear(bsdf);
    return status;
}

enum pp_status pp_bsdf_file_read(struct pp_bsdf *bsdf, const char *path,
                                 struct pp_error *err)
{
    char *bytes;
    size_t length;
    enum pp_status status =
        pp_read_file_regular(&bytes, &length, path, PP_BSDF_FILE_BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    status = length > PP_BSDF_FILE_BYTES_MOST
                 ? pp_fail(err, PP_BAD_INPUT,
                           "%.200s: the file is larger than %d MB; expected coarser "
                           "data",
                           path, PP_BSDF_FILE_BYTES_MOST >> 20)
                 : pp_bsdf_file_parse(bsdf, bytes, length, path, err);
    free(bytes);
    return status;
}
