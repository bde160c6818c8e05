// Reads the page's data and shows it.

import 'uplot/dist/uPlot.min.css';
import './style/base.css';
import './style/head.css';
import './style/replay.css';
import './style/time.css';
import './style/plots.css';
import './style/robot.css';
import './style/help.css';
import './style/small.css';
import { decodePage } from './data';
import { h } from './dom';
import { robotPage } from './robot_page';
import { runPage } from './run_page';

export interface BurnishApi {
  ready: boolean;
  readonly time: number;
  readonly playing: boolean;
  readonly renderCount: number;
  /** s, first and last time that the plots show */
  readonly window: [number, number];
  runs: number;
  plots: string[];
  setTime(time: number): void;
  play(): void;
  pause(): void;
  /** value of a column of a run at the cursor; on a robot's page of one of its joints */
  value(name: string, run?: number): number;
  /** where the robot that is drawn has the frame of the tool, m, world; null where it has none */
  drawnTool(): [number, number, number] | null;
}

declare global {
  interface Window {
    burnish?: BurnishApi;
  }
}

function show(host: HTMLElement): void {
  const page = decodePage(document.getElementById('burnish-data')?.textContent ?? 'null');
  if (!page) {
    host.replaceChildren(
      h(
        'p',
        { class: 'empty' },
        'No run in this page yet: burnish fills it in and writes the copy to look at.',
      ),
    );
    return;
  }
  document.title = `${page.title} · burnish`;
  if (page.kind === 'robot' && page.robot) robotPage(page, page.robot, host);
  else if (page.runs.length > 0) runPage(page, host);
  else throw new Error('there is neither a run nor a robot in it');
}

const host = document.getElementById('app')!;
try {
  show(host);
} catch (error) {
  const text = error instanceof Error ? error.message : String(error);
  host.replaceChildren(
    h('p', { class: 'empty', role: 'alert' }, `This page cannot be shown: ${text}.`),
  );
  throw error;
}
