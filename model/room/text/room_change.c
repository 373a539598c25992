/* room_change.c - see room_change.h.
 *
 * An address is matched with the elements of the parsed file. The n-th element of the
 * tree is the n-th start tag of the text. Only the text is changed, so that the reader
 * checks the new value like any other.
 */
#include "model/room/text/room_change.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/mistakes.h"
#include "model/base/text.h"
#include "model/base/xml.h"
#include "model/room/read/read_elements.h"
#include "model/room/read/room_schema.h"
#include "model/room/text/room_tags.h"

enum { NAMES_MOST = 64, NAME_BYTES = 64 };

/* Elements matched by an address, and the furthest partial match. */
struct match {
    int tag; /* index of the visited element among the start tags */
    bool by_number;
    const char *attribute; /* attribute of the last match */
    const struct pp_element_rule *rule;
    bool *chosen; /* by start tag: true if matched */
    int count;
    bool is_named; /* true if the last part has a name or number */

    const struct pp_xml_element *scope; /* deepest element matched; NULL: none */
    const char *left;                   /* rest of the address after `scope` */
};

static const char *attribute_text(const struct pp_xml_element *element,
                                  const char *name)
{
    for (int i = 0; i < element->attribute_count; i++)
        if (strcmp(element->attributes[i].name, name) == 0)
            return element->attributes[i].value;
    return NULL;
}

/* The n-th name of an element (name, ref, wall); NULL if it has none. */
static const char *part_name(const struct pp_xml_element *element, int n)
{
    static const char *const keys[] = {"name", "ref", "wall"};
    return n < 3 ? attribute_text(element, keys[n]) : NULL;
}

/* The rest of the address after `word` and a dot; NULL if the address does not begin
 * with `word` and a dot. */
static const char *behind_word(const char *address, const char *word)
{
    size_t length = strlen(word);
    return length > 0 && strncmp(address, word, length) == 0 && address[length] == '.'
               ? address + length + 1
               : NULL;
}

static const struct pp_element_rule *rule_of_root(const struct pp_xml_element *root)
{
    return strcmp(root->name, "building") == 0 ? &pp_rule_building : &pp_rule_room;
}

static const struct pp_element_rule *rule_of_child(const struct pp_element_rule *parent,
                                                   const char *name)
{
    for (int i = 0; parent && i < parent->child_count; i++)
        if (strcmp(parent->children[i].rule->name, name) == 0)
            return parent->children[i].rule;
    return NULL;
}

static int count_elements(const struct pp_xml_element *element)
{
    int count = 1;
    for (const struct pp_xml_element *child = element->child; child;
         child = child->next)
        count += count_elements(child);
    return count;
}

/* Number of the child among children of the same kind, from 1; 1 for the root. */
static int number_of(const struct pp_xml_element *parent,
                     const struct pp_xml_element *child)
{
    int number = 1;
    for (const struct pp_xml_element *before = parent ? parent->child : child;
         before != child; before = before->next)
        number += strcmp(before->name, child->name) == 0;
    return number;
}

/* True if the name of a child begins the address. */
static bool goes_on(const struct pp_xml_element *element, const char *address)
{
    for (const struct pp_xml_element *child = element->child; child;
         child = child->next)
        if (behind_word(address, child->name))
            return true;
    return false;
}

static void match_part(struct match *match, const struct pp_xml_element *parent,
                       const struct pp_xml_element *element,
                       const struct pp_element_rule *rule, int tag,
                       const char *address);

/* Matches the rest of an address whose earlier part is the element: an attribute, or
 * further children. */
static void match_rest(struct match *match, const struct pp_xml_element *element,
                       const struct pp_element_rule *rule, int tag, const char *left,
                       bool is_named)
{
    if (!match->left || strlen(left) < strlen(match->left)) {
        match->scope = element;
        match->left = left;
    }
    if (!strchr(left, '.')) {
        match->count += !match->chosen[tag];
        match->chosen[tag] = true;
        match->attribute = left;
        match->rule = rule;
        match->is_named = is_named;
        return;
    }
    int child_tag = tag + 1;
    for (const struct pp_xml_element *child = element->child; child;
         child = child->next) {
        match_part(match, element, child, rule_of_child(rule, child->name), child_tag,
                   left);
        child_tag += count_elements(child);
    }
}

/* Matches the first part of the address against the element. */
static void match_part(struct match *match, const struct pp_xml_element *parent,
                       const struct pp_xml_element *element,
                       const struct pp_element_rule *rule, int tag, const char *address)
{
    const char *left = behind_word(address, element->name);
    if (!left)
        return;
    bool named = false;
    for (int n = 0; n < 3; n++) {
        const char *name = part_name(element, n);
        const char *behind = name ? behind_word(left, name) : NULL;
        if (behind)
            match_rest(match, element, rule, tag, behind, true);
        named |= behind != NULL;
    }
    if (match->by_number && isdigit((unsigned char)left[0])) {
        char digits[16];
        snprintf(digits, sizeof digits, "%d", number_of(parent, element));
        const char *behind = behind_word(left, digits);
        if (behind)
            match_rest(match, element, rule, tag, behind, true);
    } else if (!named && (!strchr(left, '.') || goes_on(element, left))) {
        match_rest(match, element, rule, tag, left, false);
    }
}

/* Matches the address at every element of the tree. Returns the number of elements. */
static int match_tree(struct match *match, const struct pp_xml_element *parent,
                      const struct pp_xml_element *element,
                      const struct pp_element_rule *rule, int tag, const char *address)
{
    int next = tag + 1;
    match_part(match, parent, element, rule, tag, address);
    for (const struct pp_xml_element *child = element->child; child;
         child = child->next)
        next += match_tree(match, element, child, rule_of_child(rule, child->name),
                           next, address);
    return next - tag;
}

/* ---- messages ---- */

struct name_list {
    char texts[NAMES_MOST][NAME_BYTES];
    const char *names[NAMES_MOST];
    int count;
};

static void add_name(struct name_list *list, const char *name)
{
    for (int i = 0; i < list->count; i++)
        if (strcmp(list->names[i], name) == 0)
            return;
    if (list->count == NAMES_MOST)
        return;
    snprintf(list->texts[list->count], NAME_BYTES, "%s", name);
    list->names[list->count] = list->texts[list->count];
    list->count++;
}

/* Lists the children of that kind by name or number; kind NULL: lists the kinds of all
 * children. deep: includes all descendants. */
static void list_parts(struct name_list *list, const struct pp_xml_element *element,
                       const char *kind, bool deep)
{
    int number = 0;
    for (const struct pp_xml_element *child = element->child; child;
         child = child->next) {
        char name[NAME_BYTES];
        if (!kind) {
            add_name(list, child->name);
        } else if (strcmp(child->name, kind) == 0) {
            const char *own = part_name(child, 0);
            own = own                   ? own
                  : part_name(child, 1) ? part_name(child, 1)
                                        : part_name(child, 2);
            if (own && strlen(own) < NAME_BYTES / 2)
                snprintf(name, sizeof name, "%.20s.%.40s", kind, own);
            else
                snprintf(name, sizeof name, "%.20s.%d", kind, number + 1);
            add_name(list, name);
            number++;
        }
        if (deep)
            list_parts(list, child, kind, true);
    }
}

/* Writes the part of the address that does not exist, for a message. Names may contain
 * dots, so this is the beginning of `left` that resembles one of the names in the list,
 * or else the kind and the text up to the next dot. */
static void write_wanted(char wanted[NAME_BYTES], const char *left,
                         const struct name_list *list)
{
    const char *first = strchr(left, '.'), *end = first ? strchr(first + 1, '.') : NULL;
    for (const char *at = end; at && at - left < NAME_BYTES; at = strchr(at + 1, '.')) {
        snprintf(wanted, NAME_BYTES, "%.*s", (int)(at - left), left);
        if (pp_text_nearest(wanted, list->names, list->count))
            return;
    }
    snprintf(wanted, NAME_BYTES, "%.*s", end ? (int)(end - left) : NAME_BYTES, left);
}

static enum pp_status refuse_address(const struct match *match, const char *address,
                                     const struct pp_xml_element *root,
                                     struct pp_error *err)
{
    char kind[NAME_BYTES], wanted[NAME_BYTES];
    struct name_list list = {.count = 0};
    const char *left = match->left ? match->left : address;
    const struct pp_xml_element *scope = match->scope ? match->scope : root;
    snprintf(kind, sizeof kind, "%.*s", (int)strcspn(left, "."), left);
    list_parts(&list, scope, kind, !match->scope);
    bool is_known = list.count > 0;
    if (!is_known)
        list_parts(&list, scope, NULL, !match->scope);
    if (list.count == 0)
        return pp_fail(err, PP_BAD_INPUT, "\"%.100s\": %s has no parts", address,
                       scope->name);
    write_wanted(wanted, is_known ? left : kind, &list);
    return pp_text_unknown(err, wanted, list.names, list.count, NULL,
                           "\"%.100s\": there is no %s", address, wanted);
}

static enum pp_status check_attribute(const struct match *match, const char *address,
                                      struct pp_error *err)
{
    const char *names[NAMES_MOST];
    int count = 0;
    if (!match->rule)
        return PP_OK; /* unknown element, reported by the reader */
    for (int i = 0; i < match->rule->attribute_count && count < NAMES_MOST; i++) {
        names[count++] = match->rule->attributes[i].name;
        if (strcmp(names[count - 1], match->attribute) == 0)
            return PP_OK;
    }
    return pp_text_unknown(err, match->attribute, names, count, NULL,
                           "\"%.100s\": a %s has no %.40s", address, match->rule->name,
                           match->attribute);
}

/* ---- the text ---- */

/* Writes the start tag with a new value of the attribute; a missing attribute is
 * added. */
static void put_changed_tag(FILE *out, struct pp_room_tag tag, const char *attribute,
                            const char *value)
{
    struct pp_room_tag old = pp_room_tags_attribute(tag, attribute);
    if (old.from < tag.to) {
        fwrite(tag.from, 1, (size_t)(old.from - tag.from), out);
        pp_room_tags_put_escaped(out, value);
        fwrite(old.to, 1, (size_t)(tag.to - old.to), out);
        return;
    }
    const char *name_end = tag.from + strcspn(tag.from, " \t\r\n/>");
    fwrite(tag.from, 1, (size_t)(name_end - tag.from), out);
    fprintf(out, " %s=\"", attribute);
    pp_room_tags_put_escaped(out, value);
    fputc('"', out);
    fwrite(name_end, 1, (size_t)(tag.to - name_end), out);
}

static enum pp_status write_changed(char **changed, size_t *changed_length,
                                    const char *text, size_t length,
                                    const struct match *match, const char *value,
                                    struct pp_error *err)
{
    FILE *out = open_memstream(changed, changed_length);
    if (!out)
        return pp_fail_memory(err);
    const char *at = text, *end = text + length;
    int number = 0;
    for (struct pp_room_tag tag = pp_room_tags_next(at, end); tag.from < end;
         tag = pp_room_tags_next(tag.to, end)) {
        if (!match->chosen[number++])
            continue;
        fwrite(at, 1, (size_t)(tag.from - at), out);
        put_changed_tag(out, tag, match->attribute, value);
        at = tag.to;
    }
    fwrite(at, 1, (size_t)(end - at), out);
    bool failed = ferror(out);
    if (fclose(out) == 0 && !failed)
        return PP_OK;
    free(*changed);
    *changed = NULL;
    return pp_fail_memory(err);
}

/* Makes one change in well-formed text; *changed stays NULL if nothing changes. */
static enum pp_status change_tree(char **changed, size_t *changed_length,
                                  const char *text, size_t length,
                                  const struct pp_xml_element *root,
                                  const struct pp_room_change *change, bool lenient,
                                  struct pp_error *err)
{
    struct match match = {.chosen = calloc((size_t)count_elements(root) + 1, 1)};
    if (!match.chosen)
        return pp_fail_memory(err);
    match_tree(&match, NULL, root, rule_of_root(root), 0, change->address);
    match.by_number = match.count == 0;
    if (match.by_number)
        match_tree(&match, NULL, root, rule_of_root(root), 0, change->address);
    enum pp_status status = PP_OK;
    if (match.count == 0)
        status = lenient ? PP_OK : refuse_address(&match, change->address, root, err);
    else if (match.is_named && match.count > 1)
        status = pp_fail(err, PP_BAD_INPUT,
                         "\"%.100s\": %d parts have this address; expected only one, "
                         "such as room.NAME.%.100s",
                         change->address, match.count, change->address);
    else
        status = check_attribute(&match, change->address, err);
    if (status == PP_OK && match.count > 0)
        status = write_changed(changed, changed_length, text, length, &match,
                               change->value, err);
    free(match.chosen);
    return status;
}

/* Makes one change; *changed stays NULL if nothing changes. */
static enum pp_status change_once(char **changed, size_t *changed_length,
                                  const char *text, size_t length,
                                  const struct pp_room_change *change, bool lenient,
                                  struct pp_error *err)
{
    struct pp_xml xml;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "");
    enum pp_status status =
        pp_xml_parse(&xml, text, length, &pp_read_elements_format, &mistakes, err);
    if (status == PP_OK && xml.root && xml.whole && mistakes.count == 0)
        status = change_tree(changed, changed_length, text, length, xml.root, change,
                             lenient, err);
    pp_xml_clear(&xml);
    pp_mistakes_clear(&mistakes);
    return status;
}

enum pp_status pp_room_change_text(char **changed, size_t *changed_length,
                                   const char *text, size_t length,
                                   const struct pp_room_changes *changes,
                                   struct pp_error *err)
{
    *changed = malloc(length + 1);
    *changed_length = length;
    if (!*changed)
        return pp_fail_memory(err);
    memcpy(*changed, text, length);
    (*changed)[length] = '\0';
    for (int i = 0; i < changes->count; i++) {
        char *next = NULL;
        size_t next_length;
        enum pp_status status =
            change_once(&next, &next_length, *changed, *changed_length,
                        &changes->list[i], changes->lenient, err);
        if (status != PP_OK) {
            free(*changed);
            *changed = NULL;
            return status;
        }
        if (!next)
            continue;
        free(*changed);
        *changed = next;
        *changed_length = next_length;
    }
    return PP_OK;
}
