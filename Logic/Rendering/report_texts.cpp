#include <Rendering/report_texts.hpp>

namespace f2b::report_texts
{

const char* const style = R"css(
:root { --ink: #1c2127; --pale: #535c66; --line: #cfd5db; --band: #f3f5f7; --accent: #0b4f7d; }
* { box-sizing: border-box; }
html { font: 16px/1.5 "Helvetica Neue", Arial, "Liberation Sans", "DejaVu Sans", sans-serif; }
body { max-width: 62rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; color: var(--ink);
  background: #fff; overflow-wrap: break-word; }
header { border-bottom: 3px solid var(--accent); padding-bottom: .8rem; margin-bottom: 1.2rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; }
.case { font-size: 1.15rem; color: var(--pale); margin: .2rem 0 0; }
h2 { font-size: 1.3rem; margin: 2.4rem 0 .6rem; color: var(--accent); break-after: avoid; }
h3 { font-size: 1.05rem; margin: 1.4rem 0 .4rem; break-after: avoid; }
p { margin: .4rem 0; max-width: 46rem; }
.note { color: var(--pale); font-size: .9rem; }
.device { border: 2px solid #9a3412; background: #fff7ed; padding: .6rem .9rem; margin: 1rem 0;
  max-width: none; }
.box { border-left: 4px solid var(--accent); background: var(--band); padding: .6rem 1rem; }
.warning { border-left: 4px solid #b45309; background: #fffbeb; padding: .6rem 1rem; }
.method, .box, .warning { break-inside: avoid; }
.box h3, .warning h3 { margin-top: .2rem; }
.box ul, .warning ul { margin: .3rem 0; padding-left: 1.2rem; }
table { border-collapse: collapse; margin: .6rem 0 1rem; width: 100%; break-inside: avoid;
  font-variant-numeric: tabular-nums; }
caption { caption-side: top; text-align: left; color: var(--pale); font-size: .9rem;
  padding-bottom: .3rem; }
th, td { text-align: left; vertical-align: top; padding: .35rem .7rem;
  border-bottom: 1px solid var(--line); }
thead th { border-bottom: 2px solid var(--ink); background: var(--band); }
tbody th { font-weight: 600; }
.facts tbody th { width: 34%; font-weight: 400; color: var(--pale); }
td.number, th.number { text-align: right; }
figure { margin: 1.2rem 0 1.8rem; break-inside: avoid; }
figure img { display: block; width: 100%; height: auto; border: 1px solid var(--line); }
figcaption { margin-top: .4rem; font-size: .92rem; color: var(--pale); }
figcaption strong { color: var(--ink); }
footer { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: .6rem;
  color: var(--pale); font-size: .9rem; }
@page { size: A4; margin: 16mm 15mm; }
@media print {
  html { font-size: 10.5pt; }
  body { max-width: none; padding: 0; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
}
)css";

} // namespace f2b::report_texts
