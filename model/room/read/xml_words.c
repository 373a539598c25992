/* xml_words.c - see xml_words.h.
 *
 * The parser calls most of what may be wrong an invalid token. What stands before the place
 * is well-formed, so that reading on from the tag's < to there tells what was expected.
 */
#include "model/room/read/xml_words.h"

#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/read/xml_bytes.h"

static const char no_name[] =
    "a name was expected after < or &; write &lt; or &amp; for the sign itself";
static const char no_semicolon[] =
    "an & without its name and semicolon; write &amp; for the sign itself";
static const char malformed_tag[] = "a tag is malformed here; expected a space, > or "
                                    "/>, or is a quotation mark missing?";
static const char not_xml[] = "this is not XML; expected a <room> or a <building>";

static bool stands_at(const struct pp_xml_place *place, size_t at, const char *what)
{
    size_t length = strlen(what);
    return at <= place->length && place->length - at >= length
           && memcmp(place->bytes + at, what, length) == 0;
}

/* Where `what` begins next, from `at` on; the length of the bytes where it does not. */
static size_t find(const struct pp_xml_place *place, size_t at, const char *what)
{
    const char *found =
        memmem(place->bytes + at, place->length - at, what, strlen(what));
    return found ? (size_t)(found - place->bytes) : place->length;
}

/* Of the tag, comment, CDATA section or processing instruction that the place lies in, the
 * beginning; the place itself where it lies between them. */
static size_t markup_start(const struct pp_xml_place *place)
{
    const char *end = place->bytes + place->length;
    for (size_t p = 0;;) {
        bool is_tag;
        p = find(place, p, "<");
        if (p >= place->position)
            return place->position;
        size_t next = (size_t)(pp_xml_bytes_markup_end(place->bytes + p, end, &is_tag)
                               - place->bytes);
        if (next > place->position)
            return p;
        p = next;
    }
}

/* A sentence on what is wrong at the place, and the place of its cause. */
struct diagnosis {
    const char *sentence;
    size_t cause;
};

/* In the quotation that begins at `open`. */
static struct diagnosis wrong_in_value(const struct pp_xml_place *place, size_t open)
{
    size_t here = place->position;
    if (place->bytes[here] == '<')
        return (struct diagnosis){"a < in an attribute's value; write &lt;, or is a "
                                  "quotation mark missing?",
                                  open};
    return (struct diagnosis){place->bytes[here - 1] == '&' ? no_name : no_semicolon,
                              here};
}

/* What the parts of a tag are, in their order. */
enum tag_part { NAME, SPACE, ATTRIBUTE, EQUALS, VALUE, BEHIND_VALUE, SLASH };

/* The part that a byte of a well-formed tag begins or goes on with. */
static enum tag_part next_part(enum tag_part part, char c, char *quote)
{
    bool white = pp_text_is_white(c);
    switch (part) {
    case NAME:
    case SPACE:
    case BEHIND_VALUE:
        return white ? SPACE : c == '/' ? SLASH : part == SPACE ? ATTRIBUTE : part;
    case ATTRIBUTE:
        return c == '=' ? EQUALS : ATTRIBUTE;
    case EQUALS:
        *quote = c;
        return white ? EQUALS : VALUE;
    case VALUE:
        return c == *quote ? BEHIND_VALUE : VALUE;
    default:
        return part;
    }
}

/* In the tag that begins at `start`. */
static struct diagnosis wrong_in_tag(const struct pp_xml_place *place, size_t start)
{
    size_t here = place->position, name = start + 1, open = start;
    bool is_end = stands_at(place, start, "</");
    name += is_end;
    if (here <= name)
        return (struct diagnosis){no_name, here};
    enum tag_part part = NAME;
    char quote = '\0';
    for (size_t p = name; p < here; p++) {
        enum tag_part next = next_part(part, place->bytes[p], &quote);
        if (next == VALUE && part == EQUALS)
            open = p;
        part = next;
    }
    if (part == VALUE)
        return wrong_in_value(place, open);
    if (place->bytes[here] == '<'
        && (part == NAME || part == SPACE || part == BEHIND_VALUE))
        return (struct diagnosis){"this tag is not closed; expected > or /> at its end",
                                  start};
    if (is_end || part == SLASH)
        return (struct diagnosis){"a tag is not closed; expected > or />", here};
    if (part == ATTRIBUTE)
        return (struct diagnosis){"an attribute has no value; write name=\"value\"",
                                  here};
    if (part == EQUALS)
        return (struct diagnosis){
            "an attribute's value is not in quotation marks; write name=\"value\"",
            here};
    return (struct diagnosis){malformed_tag, here};
}

/* A control character, U+FFFE and U+FFFF. */
static bool is_no_character(const struct pp_xml_place *place)
{
    unsigned char c = (unsigned char)place->bytes[place->position];
    return (c < ' ' && !pp_text_is_white((char)c))
           || stands_at(place, place->position, "\xEF\xBF\xBE")
           || stands_at(place, place->position, "\xEF\xBF\xBF");
}

static struct diagnosis invalid_token(const struct pp_xml_place *place)
{
    size_t here = place->position;
    if (is_no_character(place))
        return (struct diagnosis){"a control character that XML does not allow", here};
    size_t start = markup_start(place);
    if (start != here) {
        if (stands_at(place, start, "<!--"))
            return (struct diagnosis){"two hyphens -- within a comment", here};
        if (stands_at(place, start, "<?"))
            return (struct diagnosis){"a <?...?> is malformed; it begins with a name",
                                      start};
        return wrong_in_tag(place, start);
    }
    if (!place->begun)
        return (struct diagnosis){not_xml, here};
    if (!place->open)
        return (struct diagnosis){"something stands behind the end of the room; a file "
                                  "holds one room or building",
                                  here};
    for (size_t back = 0; back < 3 && back <= here; back++)
        if (stands_at(place, here - back, "]]>"))
            return (struct diagnosis){"]]> stands between elements", here - back};
    return (struct diagnosis){
        here > 0 && place->bytes[here - 1] == '&' ? no_name : no_semicolon, here};
}

/* What begins at the place has no end in the file. */
static struct diagnosis unclosed(const struct pp_xml_place *place)
{
    size_t here = place->position;
    if (stands_at(place, here, "<!--"))
        return (struct diagnosis){"a comment <!-- has no end; expected -->", here};
    if (stands_at(place, here, "<?"))
        return (struct diagnosis){"a <? has no end; expected ?>", here};
    return (struct diagnosis){NULL, place->length};
}

/* The CDATA section that has no end, of what the parser has passed. */
static struct diagnosis unclosed_cdata(const struct pp_xml_place *place)
{
    struct pp_xml_place end = *place;
    end.position = end.length - 1;
    return (struct diagnosis){"a <![CDATA[ has no end; expected ]]>",
                              markup_start(&end)};
}

static struct diagnosis wrong_declaration(const struct pp_xml_place *place)
{
    struct pp_xml_place declaration = {.bytes = place->bytes,
                                       .length = find(place, 0, "?>")};
    bool has_version = find(&declaration, 0, "version") < declaration.length;
    return (struct diagnosis){
        has_version
            ? "the <?xml ...?> at the start is malformed"
            : "the <?xml ...?> at the start has no version; write version=\"1.0\"",
        place->position};
}

/* NULL as a sentence: the file breaks off. */
static struct diagnosis diagnose(enum XML_Error error, const struct pp_xml_place *place)
{
    size_t here = place->position;
    switch (error) {
    case XML_ERROR_INVALID_TOKEN:
    case XML_ERROR_SYNTAX:
    case XML_ERROR_JUNK_AFTER_DOC_ELEMENT:
        return here < place->length ? invalid_token(place)
                                    : (struct diagnosis){NULL, place->length};
    case XML_ERROR_UNCLOSED_TOKEN:
    case XML_ERROR_PARTIAL_CHAR:
        return unclosed(place);
    case XML_ERROR_NO_ELEMENTS:
        return (struct diagnosis){place->begun ? NULL : not_xml, place->length};
    case XML_ERROR_BAD_CHAR_REF:
        return (struct diagnosis){
            "a reference like &#...; to nothing, or to a control character that "
            "XML does not allow",
            here};
    case XML_ERROR_MISPLACED_XML_PI:
        return (struct diagnosis){
            "<?xml ...?> must be the very first thing in the file", here};
    case XML_ERROR_UNCLOSED_CDATA_SECTION:
        return unclosed_cdata(place);
    case XML_ERROR_XML_DECL:
        return wrong_declaration(place);
    default:
        return (struct diagnosis){"the file is not well-formed XML", here};
    }
}

/* An excerpt of the name that begins at `at`. */
static const char *name_at(char *text, size_t size, const struct pp_xml_place *place,
                           size_t at)
{
    char copy[128];
    size_t length = 0;
    while (at + length < place->length && length < sizeof copy - 1
           && !strchr(" \t\r\n=/>;\"'<", place->bytes[at + length]))
        length++;
    memcpy(copy, place->bytes + at, length);
    copy[length] = '\0';
    return pp_text_excerpt(text, size, copy);
}

/* Where the first & of an unknown name is, from the place on. */
static size_t unknown_entity(const struct pp_xml_place *place)
{
    static const char *const known[] = {"&#",   "&amp;",  "&lt;",
                                        "&gt;", "&quot;", "&apos;"};
    for (size_t p = place->position;; p++) {
        p = find(place, p, "&");
        if (p == place->length)
            return place->position;
        bool is_known = false;
        for (size_t i = 0; i < sizeof known / sizeof *known; i++)
            is_known = is_known || stands_at(place, p, known[i]);
        if (!is_known)
            return p;
    }
}

size_t pp_xml_words_sentence(char *text, size_t size, enum XML_Error error,
                             const struct pp_xml_place *place)
{
    const struct pp_xml_element *open = place->open;
    char one[160], other[160];
    size_t here = place->position, entity;
    switch (error) {
    case XML_ERROR_TAG_MISMATCH:
        snprintf(text, size, "</%s> where </%s> was expected, to close line %d",
                 name_at(other, sizeof other, place,
                         here + (stands_at(place, here, "</") ? 2 : 0)),
                 pp_text_excerpt(one, sizeof one, open ? open->name : ""),
                 open ? open->line : 1);
        return here;
    case XML_ERROR_DUPLICATE_ATTRIBUTE:
        snprintf(text, size, "the attribute \"%s\" is given twice",
                 name_at(one, sizeof one, place, here));
        return here;
    case XML_ERROR_UNDEFINED_ENTITY:
        entity = unknown_entity(place);
        snprintf(text, size,
                 "&%s; is not known; XML has &amp; &lt; &gt; &quot; and &apos;",
                 name_at(one, sizeof one, place, entity + 1));
        return entity;
    default:
        break;
    }
    struct diagnosis diagnosis = diagnose(error, place);
    if (diagnosis.sentence)
        snprintf(text, size, "%s", diagnosis.sentence);
    else if (open)
        snprintf(text, size,
                 "the file breaks off within <%s> of line %d; expected </%s>",
                 pp_text_excerpt(one, sizeof one, open->name), open->line,
                 pp_text_excerpt(other, sizeof other, open->name));
    else
        snprintf(text, size, "the file breaks off within a tag");
    return diagnosis.cause;
}
