import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import { Portal } from '@/app/Portal';
import { createApi, createConnection } from '@/shared/api';

const root = document.getElementById('root');
if (!root) throw new Error('index.html has no element #root');

const connection = createConnection();
const server = { api: createApi(window.location.origin, connection), connection };

createRoot(root).render(
  <StrictMode>
    <Portal server={server} />
  </StrictMode>,
);
