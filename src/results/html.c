/* Elements of HTML, escaped, and the page's frame (see html.h). */
#include "results/html.h"

/* One column of text at most 76 rem wide; pictures and figures share a row where there is room; wide tables scroll inside
 * their own box; on a phone each row of the verdict table becomes a card. */
static const char style[] =
    ":root{--ink:#1b1f24;--soft:#57606a;--line:#d0d7de;--paper:#fff;--tint:#f6f8fa}\n"
    "*{box-sizing:border-box}\n"
    "body{margin:0 auto;padding:1.5rem clamp(.8rem,3vw,2.5rem) "
    "4rem;max-width:80rem;color:var(--ink);background:var(--paper);"
    "font:16px/1.5 system-ui,\"DejaVu Sans\",sans-serif}\n"
    "h1{font-size:1.8rem;line-height:1.2;margin:.5rem 0 1rem}\n"
    "h2{font-size:1.35rem;margin:2.8rem 0 .6rem;padding-top:.6rem;border-top:1px solid var(--line)}\n"
    "h3{font-size:1.05rem;margin:1.6rem 0 .4rem}\n"
    "p{margin:.5rem 0;max-width:48rem}\n"
    ".lead{font-size:1.1rem}\n"
    "code,pre{font:.85em/1.45 ui-monospace,\"DejaVu Sans Mono\",monospace;overflow-wrap:anywhere}\n"
    "pre{background:var(--tint);padding:.8rem 1rem;border-radius:6px;white-space:pre-wrap;max-width:60rem}\n"
    ".word{display:inline-block;max-width:100%}\n"
    "table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.35rem .7rem;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}\n"
    "th{background:var(--tint);font-weight:600}\n"
    ".data td,.data th{white-space:nowrap}\n"
    ".scroll{overflow-x:auto;max-height:34rem;overflow-y:auto;border:1px solid "
    "var(--line);border-radius:6px;margin:.6rem 0}\n"
    ".scroll thead th{position:sticky;top:0}\n"
    ".verdict{display:inline-block;padding:.05rem "
    ".55rem;border-radius:1rem;white-space:nowrap;font-weight:600;"
    "border:1px solid currentColor}\n"
    ".holds{color:#0b5d8f;background:#e6f2fa}.upto{color:#7a4d00;background:#fdf3dc}\n"
    ".fails{color:#a3330c;background:#fdece4}.inconclusive{color:#4b535c;background:#eef0f2}\n"
    ".note{color:var(--soft);font-size:.85em;display:block}\n"
    ".row{display:grid;gap:1rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,15rem),1fr));margin:."
    "8rem 0}\n"
    ".plots{display:grid;gap:1.4rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,32rem),1fr));"
    "margin:1rem 0}\n"
    "figure{margin:0;min-width:0}\n"
    "figure img{display:block;width:100%;height:auto;border:1px solid "
    "var(--line);border-radius:4px;background:#fff}\n"
    "figcaption{font-size:.88rem;color:var(--soft);margin-top:.35rem}\n"
    "details{margin:.6rem 0}summary{cursor:pointer;color:#0b5d8f}\n"
    "@media (max-width:45rem){.claims thead{display:none}.claims,.claims tbody,.claims tr,.claims "
    "td{display:block;width:100%}"
    ".claims tr{border:1px solid var(--line);border-radius:6px;margin:.7rem 0;padding:.3rem 0}.claims "
    "td{border:0}"
    ".claims td:nth-child(n+4)::before{content:attr(data-label) \": \";color:var(--soft)}}\n"
    "@media print{.scroll{max-height:none;overflow:visible}body{font-size:11pt}}\n";

void rl_html_text(struct rl_buffer *page, const char *text)
{
    for (; *text; text++) {
        switch (*text) {
        case '&':
            rl_buffer_add(page, "&amp;");
            break;
        case '<':
            rl_buffer_add(page, "&lt;");
            break;
        case '>':
            rl_buffer_add(page, "&gt;");
            break;
        case '"':
            rl_buffer_add(page, "&quot;");
            break;
        case '\'':
            rl_buffer_add(page, "&#39;");
            break;
        default:
            rl_buffer_printf(page, "%c", *text);
        }
    }
}

void rl_html_element(struct rl_buffer *page, const char *tag, const char *text)
{
    rl_buffer_printf(page, "<%s>", tag);
    rl_html_text(page, text);
    rl_buffer_printf(page, "</%s>\n", tag);
}

void rl_html_begin(struct rl_buffer *page, const char *title)
{
    rl_buffer_add(page, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    rl_html_element(page, "title", title);
    rl_buffer_printf(page, "<style>\n%s</style>\n</head>\n<body>\n", style);
}

void rl_html_end(struct rl_buffer *page)
{
    rl_buffer_add(page, "</body>\n</html>\n");
}

void rl_html_figure(struct rl_buffer *page, const char *source, const char *alternative, const char *caption,
                    const struct rl_html_link *links)
{
    rl_buffer_add(page, "<figure><img src=\"");
    rl_html_text(page, source);
    rl_buffer_add(page, "\" alt=\"");
    rl_html_text(page, alternative);
    rl_buffer_add(page, "\"><figcaption>");
    rl_html_text(page, caption);
    for (; links && links->label; links++) {
        rl_buffer_add(page, " <a href=\"");
        rl_html_text(page, links->href);
        rl_buffer_add(page, "\">");
        rl_html_text(page, links->label);
        rl_buffer_add(page, "</a>");
    }
    rl_buffer_add(page, "</figcaption></figure>\n");
}
