"""How the .html result looks: light and dark, on a screen and on paper."""

STYLE = """
:root { color-scheme: light dark; --ink: #1f2430; --quiet: #687080; --paper: #ffffff;
  --wash: #f5f6f8; --rule: #dfe2e7; --warn: #8a5a00; --warn-wash: #fff6e0; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8ec; --quiet: #9aa2b1; --paper: #15181e;
  --wash: #1d2129; --rule: #333945; --warn: #f0c36a; --warn-wash: #2c2413; } }
@media print { :root { color-scheme: light; --ink: #000; --quiet: #555; --paper: #fff;
  --wash: #fff; --rule: #bbb; --warn: #000; --warn-wash: #fff; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, "Segoe UI", Roboto, "Helvetica Neue", "DejaVu Sans", sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2.5rem 1.5rem 4rem; }
header p, .quiet { color: var(--quiet); margin: 0; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: .15em 0 .3em; font-weight: 650;
  letter-spacing: -.01em; overflow-wrap: anywhere; }
h1 span { color: var(--quiet); font-weight: 400; }
h2 { font-size: 1.15rem; margin: 2.6rem 0 .8rem; font-weight: 650; }
.key { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: 1px;
  border: 1px solid var(--rule); border-radius: 10px; overflow: hidden; margin: 1.8rem 0; }
.key div { box-shadow: 0 0 0 1px var(--rule); padding: .9rem 1.1rem; }
.key dt { color: var(--quiet); font-size: .85rem; }
.key dd { margin: .1rem 0 0; font-size: 1.55rem; font-weight: 600;
  font-variant-numeric: tabular-nums; }
.key dd small { font-size: .95rem; font-weight: 400; color: var(--quiet); }
.warn { background: var(--warn-wash); border-left: 3px solid var(--warn); margin: 1.5rem 0;
  padding: .8rem 1.1rem; border-radius: 0 8px 8px 0; }
.warn b { color: var(--warn); }
.warn ul { margin: .3rem 0 0; padding-left: 1.2rem; }
figure { margin: 0; }
figure img { display: block; width: 100%; height: auto; background: #fff; border-radius: 8px;
  border: 1px solid var(--rule); }
figcaption { color: var(--quiet); font-size: .88rem; margin-top: .5rem; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(22rem, 1fr)); gap: 1.2rem;
  margin-bottom: 1.2rem; }
table { border-collapse: collapse; width: 100%; font-size: .93rem; }
th, td { text-align: left; vertical-align: top; padding: .34rem .9rem .34rem 0;
  border-bottom: 1px solid var(--rule); }
th { font-weight: 400; color: var(--quiet); white-space: nowrap; width: 1%; padding-right: 1.6rem; }
.measures th { color: var(--ink); }
th[scope=rowgroup] { font-weight: 650; padding-top: 1.3rem; white-space: normal; }
th[scope=rowgroup] small { font-weight: 400; color: var(--quiet); font-size: .88rem; }
.regions { display: block; overflow-x: auto; }
.regions tr > * { padding-right: 1.4rem; }
.regions th[scope=row] { color: var(--ink); }
.regions th[scope=col], .regions td.number { text-align: right; }
.regions th[scope=col]:first-child { text-align: left; }
.regions tr:last-child > * { font-weight: 650; border-bottom: 0; }
.regions i { display: inline-block; width: .7em; height: .7em; border-radius: 50%;
  margin-right: .5em; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
section > p { color: var(--quiet); font-size: .93rem; margin: .6rem 0; }
td { overflow-wrap: anywhere; }
td.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; width: 1%;
  padding-right: .4rem; }
td.unit { color: var(--quiet); white-space: nowrap; width: 1%; padding-right: 2rem; }
td.text { color: var(--quiet); }
code, pre { font: .85em/1.5 ui-monospace, "SF Mono", Consolas, "DejaVu Sans Mono", monospace; }
pre { margin: 0; overflow-x: auto; }
footer { margin-top: 3rem; padding-top: 1rem; border-top: 1px solid var(--rule);
  color: var(--quiet); font-size: .88rem; }
footer strong { color: var(--ink); font-weight: 600; }
@media print { @page { size: A4; margin: 16mm 15mm; } body { font-size: 10pt; }
  main { max-width: none; padding: 0; } h2 { break-after: avoid; margin-top: 1.6rem; }
  figure, tr, .key, .warn { break-inside: avoid; } .pair { grid-template-columns: 1fr 1fr; }
  .key { grid-template-columns: repeat(5, 1fr); } .key dd { font-size: 1.2rem; } }
"""
