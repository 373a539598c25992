/* xml_sentence.c - see xml_sentence.h. */
#include "model/base/xml_sentence.h"

#include <libxml/xmlerror.h>
#include <stddef.h>
#include <string.h>

static const char no_name[] =
    "expected a name after < or &; write &lt; or &amp; for the character itself";
static const char bad_tag[] =
    "this tag is malformed; expected a space, > or />, or a missing quotation mark";
static const char open_tag[] = "this tag is not closed; expected > or /> at its end";
static const char bad_start[] = "the <?xml ...?> at the start of the file is malformed";
static const char bad_reference[] = "this character reference &#...; is empty, or "
                                    "stands for a control character that XML does not "
                                    "allow";
static const char bad_letter[] = "there is a control character, which XML does not "
                                 "allow";

static const struct {
    int code;
    enum pp_xml_cause cause;
    const char *text;
} sentences[] = {
    {XML_ERR_INVALID_HEX_CHARREF, PP_XML_HERE, bad_reference},
    {XML_ERR_INVALID_DEC_CHARREF, PP_XML_HERE, bad_reference},
    {XML_ERR_INVALID_CHAR, PP_XML_HERE, bad_letter},
    {XML_ERR_NAME_REQUIRED, PP_XML_HERE, no_name},
    {XML_ERR_ENTITYREF_SEMICOL_MISSING, PP_XML_HERE,
     "there is an & without a name and a semicolon; write &amp; for the character "
     "itself"},
    {XML_ERR_LT_IN_ATTRIBUTE, PP_XML_QUOTE,
     "there is a < in the value of an attribute; write &lt;, or add a missing "
     "quotation mark"},
    {XML_ERR_ATTRIBUTE_NOT_STARTED, PP_XML_HERE,
     "the value of an attribute is not in quotation marks; write name=\"value\""},
    {XML_ERR_ATTRIBUTE_WITHOUT_VALUE, PP_XML_HERE,
     "an attribute has no value; write name=\"value\""},
    {XML_ERR_SPACE_REQUIRED, PP_XML_HERE, bad_tag},
    {XML_ERR_GT_REQUIRED, PP_XML_HERE, bad_tag},
    {XML_ERR_HYPHEN_IN_COMMENT, PP_XML_HERE,
     "two hyphens -- are not allowed within a comment"},
    {XML_ERR_PI_NOT_STARTED, PP_XML_HERE,
     "a <?...?> is malformed; expected a name at its start"},
    {XML_ERR_RESERVED_XML_NAME, PP_XML_HERE,
     "<?xml ...?> is not at the start of the file; nothing may precede it"},
    {XML_ERR_VERSION_MISSING, PP_XML_HERE,
     "the <?xml ...?> at the start has no version; write version=\"1.0\""},
    {XML_ERR_XMLDECL_NOT_FINISHED, PP_XML_HERE, bad_start},
    {XML_ERR_STANDALONE_VALUE, PP_XML_HERE, bad_start},
    {XML_ERR_ENCODING_NAME, PP_XML_HERE, bad_start},
    {XML_ERR_UNKNOWN_VERSION, PP_XML_HERE, bad_start},
    {XML_ERR_EQUAL_REQUIRED, PP_XML_HERE, bad_start},
    {XML_ERR_STRING_NOT_STARTED, PP_XML_HERE, bad_start},
    {XML_ERR_STRING_NOT_CLOSED, PP_XML_HERE, bad_start},
    {XML_ERR_MISPLACED_CDATA_END, PP_XML_HERE, "there is a ]]> between elements"},
};

/* libxml2 reports several mistakes with one error code; the bytes around the position
 * distinguish them. */
struct pp_xml_sentence pp_xml_sentence_of_error(int error, const char *at,
                                                const char *start)
{
    struct pp_xml_sentence found = {0};
    for (size_t i = 0; i < sizeof sentences / sizeof *sentences; i++)
        if (sentences[i].code == error)
            found = (struct pp_xml_sentence){sentences[i].text, sentences[i].cause};
    char before = '\0';
    if (at > start)
        before = at[-1];
    if (found.text == no_name && before != '<' && before != '&' && before != '/')
        found.text = bad_tag;
    if (found.text == bad_tag && *at == '<')
        found = (struct pp_xml_sentence){open_tag, PP_XML_TAG};
    if (found.text == bad_letter && before == ';')
        found.text = bad_reference;
    return found;
}

const char *pp_xml_sentence_of_unended(const char *p, const char *end)
{
    static const struct {
        const char *start, *sentence;
    } unended[] = {
        {"<!--", "a comment <!-- has no end; expected -->"},
        {"<![CDATA[", "a <![CDATA[ has no end; expected ]]>"},
        {"<?", "a <? has no end; expected ?>"},
        {"<", "the file ends inside the tag that begins here; expected >"},
    };
    size_t i = 0;
    for (; unended[i].start[1]; i++) {
        size_t length = strlen(unended[i].start);
        if ((size_t)(end - p) >= length && memcmp(p, unended[i].start, length) == 0)
            break;
    }
    return unended[i].sentence;
}
